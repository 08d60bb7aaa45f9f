# SPDX-License-Identifier: MIT
"""Wrong versions of C++ sources, each with one mistake: drawn at random, or written by hand in curated.toml.

A mutant is known by its file, the function around it and the tokens that it changes. Line numbers are not kept and
white space does not count.
"""

import hashlib
import re
import tomllib
from dataclasses import dataclass, field

# The folders of a part, and what the paths of those tests contain that are nearest to it.
PARTS = {
    "solver": (["solver"], ["solver"]),
    "analytic": (["analytic"], ["analytic"]),
    "data": (["data"], ["data"]),
    "studies": (["verification/studies"], ["studies", "cross"]),
    "comparison": (["verification/comparison"], ["compar", "wrong_model", "diagnos", "users_files"]),
    "cli": (["reports/cli"], ["cli", "command"]),
}

# ---------------------------------------------------------------------------------------------------------------------
# Sources: tokens, brackets and the functions around them
# ---------------------------------------------------------------------------------------------------------------------

TOKEN = re.compile(
    r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/|\#(?:\\\n|[^\n])*)
      | (?P<text>R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
      | (?P<number>\.?\d(?:[eE][+-]|[\w.'])*)
      | (?P<word>[A-Za-z_]\w*)
      | (?P<sign><=>|<<=|>>=|\.\.\.|->|\+\+|--|<<|>>|[<>=!+*/%&|-]=|&&|\|\||::|.)""",
    re.DOTALL | re.VERBOSE,
)


@dataclass
class Token:
    kind: str
    text: str
    begin: int
    end: int


def tokens_of(text):
    """The tokens of C++ code without comments, directives and white space."""
    return [Token(m.lastgroup, m.group(m.lastgroup), m.start(), m.end())
            for m in TOKEN.finditer(text) if m.lastgroup != "skip"]


class Source:
    """A file with the partners of its brackets and the name of the function or constant around each token."""

    def __init__(self, text):
        self.text = text
        self.tokens = tokens_of(text)
        self.words = [token.text for token in self.tokens]
        self.closing = {}  # the place of the bracket that closes the one at a place
        self.around = [None] * len(self.tokens)  # the place of the bracket that is open at a token
        self.functions = [""] * len(self.tokens)
        self.bodies = [False] * len(self.tokens)  # inside the braces of a function
        self._match_brackets()
        self._name_functions()

    def _match_brackets(self):
        stack = []
        for i, word in enumerate(self.words):
            if word in (")", "]", "}") and stack:
                self.closing[stack.pop()] = i
            self.around[i] = stack[-1] if stack else None
            if word in ("(", "[", "{"):
                stack.append(i)

    def _name_functions(self):
        """Goes through the braces that are not inside a function: namespaces, classes, functions, initialisers."""
        i = head = 0
        classes = []  # names of the classes around i, each with the place of its closing brace
        while i < len(self.words):
            classes = [entry for entry in classes if entry[1] > i]
            word = self.words[i]
            if word in ("(", "["):
                i = self.closing.get(i, i)
            elif word == "{":
                close = self.closing.get(i, len(self.words) - 1)
                kind, name = self._kind_of_brace(head, i)
                if kind == "class":
                    classes.append((name, close))
                if kind in ("class", "namespace"):
                    head = i + 1
                else:
                    full = "::".join([entry[0] for entry in classes] + [name])
                    self.functions[head:close + 1] = [full] * (close + 1 - head)
                    if kind == "function":
                        self.bodies[i:close] = [True] * (close - i)
                        head = close + 1
                    i = close
            elif word in (";", "}"):
                if "=" in self.words[head:i]:  # a constant
                    name = self._name_before(head, self.words.index("=", head))
                    self.functions[head:i] = ["::".join([entry[0] for entry in classes] + [name])] * (i - head)
                head = i + 1
            i += 1

    @staticmethod
    def _is_in_angles(words):
        """Whether the next word is one of a template's arguments, as in std::function<double(double)>."""
        brackets = "".join(word for word, before in zip(words, [""] + words) if word in ("<", ">", ">>") and before != "operator")
        return brackets.count("<") > brackets.count(">")

    def _kind_of_brace(self, head, brace):
        """What a brace opens, and its name; the declaration before it begins at `head`."""
        words = self.words[head:brace]
        if "namespace" in words or words[:1] == ["extern"]:
            return "namespace", ""
        call = next((head + k for k, word in enumerate(words) if word == "(" and not self._is_in_angles(words[:k])), brace)
        equals = head + words.index("=") if "=" in words else brace
        if call < equals:
            is_body = words[-1] in (")", "}", "const", "noexcept", "override", "final", "try") or "->" in words
            return "function" if is_body else "initialiser", self._name_before(head, call)
        keys = [key for key in ("class", "struct", "union", "enum") if key in words]
        if keys and equals == brace:
            names = [word for word in words[words.index(keys[0]) + 1:] if word not in ("class", "final")]
            return "class", names[0] if names else ""
        return "initialiser", self._name_before(head, equals)

    def _name_before(self, head, place):
        """The name that ends before a place: `beam`, `Beam::mass`, `Beam::~Beam`, `operator<`."""
        found = re.search(r"(operator\W+|[\w:~]+)$", self.text[self.tokens[head].begin:self.tokens[place].begin].rstrip())
        return found[1] if found else ""

    def between(self, first, last):
        """The text of the tokens from `first` to before `last`."""
        return self.text[self.tokens[first].begin:self.tokens[last - 1].end] if last > first else ""

    def replaced(self, first, last, replacement):
        """The whole text with other text for the tokens from `first` to before `last`."""
        begin = self.tokens[first].begin
        end = self.tokens[last - 1].end if last > first else begin
        return self.text[:begin] + replacement + self.text[end:]

    def statement_end(self, i):
        """The place of the semicolon that ends the statement at `i`."""
        while i < len(self.words) and self.words[i] != ";":
            i = self.closing.get(i, i) + 1
        return i

    def arguments(self, open_bracket):
        """The ranges of the arguments in a pair of brackets."""
        close, begin, ranges, i = self.closing[open_bracket], open_bracket + 1, [], open_bracket + 1
        while i < close:
            i = self.closing.get(i, i)
            if self.words[i] == ",":
                ranges.append((begin, i))
                begin = i + 1
            i += 1
        return ranges + ([(begin, close)] if close > begin else [])


# ---------------------------------------------------------------------------------------------------------------------
# Mistakes: each function gives (first token, token after the last, replacement) for the token at i
# ---------------------------------------------------------------------------------------------------------------------

OPERATORS = {
    "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"],
    "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
}
WORDS = {"true": "false", "false": "true", "min": "max", "max": "min", "break": "continue", "continue": "break",
         "lower": "upper", "upper": "lower", "front": "back", "back": "front", "sin": "cos", "cos": "sin",
         "ceil": "floor", "floor": "ceil", "any_of": "all_of", "all_of": "any_of"}
NO_STATEMENT = set("using const auto static constexpr if for while else case default struct class template throw switch "
                   "do try catch double int bool namespace typedef enum goto".split())


def is_binary(source, i):
    """A binary operator has space on both sides; brackets of templates, pointers and signs have not."""
    token = source.tokens[i]
    return source.text[token.begin - 1].isspace() and source.text[token.end:token.end + 1].isspace()


def other_operators(source, i):
    if source.words[i] in OPERATORS and is_binary(source, i):
        yield from ((i, i + 1, other) for other in OPERATORS[source.words[i]])
    elif source.words[i] in ("-", "!") and not is_binary(source, i):
        yield i, i + 1, ""


def other_numbers(source, i):
    token = source.tokens[i]
    if token.kind != "number" or token.text.startswith("0x"):
        return
    if any(source.words[j] in ("<", ">") and not is_binary(source, j) for j in (i - 1, i + 1)):
        return  # the size of a type
    if any(c in token.text for c in ".eE"):
        yield i, i + 1, "1.0" if not token.text.strip("0.") else f"(2.0 * {token.text})"
    else:
        digits = token.text.rstrip("uUlLzZ")
        suffix, value = token.text[len(digits):], int(digits.replace("'", ""))
        yield i, i + 1, f"{value + 1}{suffix}"
        if value > 0:
            yield i, i + 1, f"{value - 1}{suffix}"


def other_words(source, i):
    if source.words[i] in WORDS:
        yield i, i + 1, WORDS[source.words[i]]
    if source.words[i:i + 3] == ["std", "::", "abs"]:
        yield i, i + 3, ""


def other_index(source, i):
    before = source.tokens[i - 1]
    if source.words[i] == "[" and (before.kind == "word" or before.text in ")]") and before.text not in ("auto", "return"):
        if source.closing[i] > i + 1 and source.tokens[i + 1].kind != "text":
            yield i + 1, source.closing[i], source.between(i + 1, source.closing[i]) + " + 1"


def negated_condition(source, i):
    if source.words[i] in ("if", "while") and source.words[i + 1] == "(":
        close = source.closing[i + 1]
        if ";" not in source.words[i:close]:
            yield i + 2, close, f"!({source.between(i + 2, close)})"


def swapped_branches(source, i):
    if source.words[i] != "?":
        return
    colon = i + 1
    while source.words[colon] != ":":
        colon = source.closing.get(colon, colon) + 1
    end = colon + 1
    while source.words[end] not in (",", ";", ")", "]", "}", ":", "?"):
        end = source.closing.get(end, end) + 1
    if source.words[end] != "?":
        yield i + 1, end, f"{source.between(colon + 1, end)} : {source.between(i + 1, colon)}"


def swapped_arguments(source, i):
    if source.words[i] != "(" or source.tokens[i - 1].kind != "word":
        return
    if source.words[i - 1] in ("if", "for", "while", "min", "max", "hypot"):  # no call, or the order does not matter
        return
    arguments = source.arguments(i)
    if len(arguments) < 2 or source.tokens[i + 1].kind == "text":
        return
    (a, b), (c, d) = arguments[:2]
    first, second = source.between(a, b), source.between(c, d)
    if first != second and b - a <= 4 and d - c <= 4:  # longer ones seldom have the same type
        yield a, d, f"{second}, {first}"


def deleted_statement(source, i):
    first, second = source.tokens[i], source.tokens[i + 1]
    before = source.words[i - 1]
    begins = before in (";", "{", "}", "else") or (before == ")" and is_head_before(source, i))
    is_in_braces = source.around[i] is not None and source.words[source.around[i]] == "{"
    if not begins or not is_in_braces or (first.kind != "word" and first.text not in ("++", "--")) or first.text in NO_STATEMENT:
        return
    if first.text == "return" and second.text != ";" or second.kind == "word":
        return  # a declaration
    end = source.statement_end(i)
    words = source.words[i:end]
    if end < len(source.words) and "{" not in words and "reserve" not in words and not is_declaration(source, i, end):
        yield i, end, ""


def is_declaration(source, i, end):
    """`Type<...> name ...`, `Type& name`, `a::Type name`: two names in a row before anything is called or assigned."""
    for j in range(i, end):
        if source.words[j] in ("(", "=", "[", "."):
            return False
        if j > i and source.tokens[j].kind == "word" and source.words[j - 1] not in ("::", "->", "<"):
            return True
    return False


def is_head_before(source, i):
    """Whether the closing bracket before i ends the head of an if, for or while."""
    opened = next(j for j, k in source.closing.items() if k == i - 1)
    return source.words[opened - 1] in ("if", "for", "while")


MISTAKES = [other_operators, other_numbers, other_words, other_index, negated_condition, swapped_branches,
            swapped_arguments, deleted_statement]


@dataclass
class Mutant:
    part: str
    file: str
    function: str
    edit: str
    text: str = field(repr=False)  # of the whole file
    seed: int = 0

    @property
    def id(self):
        return hashlib.sha1(f"{self.file}|{self.function}|{self.edit}".encode()).hexdigest()[:10]


def described(source, first, last, replacement):
    """The edit as three tokens before, the change, three tokens after."""
    old = " ".join(source.words[first:last])
    new = " ".join(token.text for token in tokens_of(replacement))
    return f"{' '.join(source.words[max(0, first - 3):first])} [{old} -> {new}] {' '.join(source.words[last:last + 3])}"


def part_of(file):
    """The part to which a file belongs."""
    return next(part for part, (folders, _) in PARTS.items() if any(file.startswith(f"{f}/") for f in folders))


def mutants_of(part, file, text):
    """All mutants of a file."""
    source, seen, i = Source(text), {}, 1
    while i < len(source.words) - 1:
        if source.words[i] in ("throw", "static_assert"):  # error messages and checks at compile time are left alone
            i = source.statement_end(i)
        for mistake in MISTAKES if source.bodies[i] else [other_numbers] if source.functions[i] else []:
            for first, last, replacement in mistake(source, i):
                edit = described(source, first, last, replacement)
                count = seen[source.functions[i], edit] = seen.get((source.functions[i], edit), 0) + 1
                edit += f" #{count}" if count > 1 else ""
                yield Mutant(part, file, source.functions[i], edit,
                             source.replaced(first, last, replacement))
        i += 1


def generated_mutants(root, part, seed):
    """All mutants of a part in the order in which the seed draws them. Headers that other parts include are left out."""
    mutants = []
    for folder in PARTS[part][0]:
        for path in sorted(p for p in (root / folder).rglob("*.[ch]pp") if "include" not in p.parts):
            mutants += mutants_of(part, str(path.relative_to(root)), path.read_text())
    for mutant in mutants:
        mutant.seed = seed
    return sorted(mutants, key=lambda mutant: hashlib.sha1(f"{seed}{mutant.id}".encode()).digest())


def curated_mutants(root, catalogue):
    """The mutants of a catalogue such as curated.toml, and a sentence for each whose edits no longer apply."""
    mutants, stale = [], []
    for file, entries in tomllib.loads(catalogue.read_text()).items():
        for name, entry in entries.items():
            try:
                text = (root / file).read_text()
                for edit in entry["edits"]:
                    text = curated_edit(text, *edit)
                mutants.append(Mutant("curated", file, entry["edits"][0][0], name, text))
            except (OSError, ValueError) as error:
                stale.append(f"stale: {name} in {file}: {error}")
    return mutants, stale


def curated_edit(text, function, old, new):
    """The text with the tokens of `old`, which stand once in the function, replaced by `new`."""
    source, wanted = Source(text), [token.text for token in tokens_of(old)]
    places = [i for i in range(len(source.words)) if source.functions[i] == function
              and source.words[i:i + len(wanted)] == wanted]
    if len(places) != 1:
        raise ValueError(f"'{old}' stands {len(places)} times in {function or 'no function'}")
    return source.replaced(places[0], places[0] + len(wanted), new)
