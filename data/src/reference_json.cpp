// SPDX-License-Identifier: MIT
#include "json_file.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace stickslip::data {

namespace {

using Json = nlohmann::ordered_json;

void read_value(const JsonNode& node, std::string& value) { value = node.text(); }
void read_value(const JsonNode& node, std::vector<std::string>& value) { value = node.texts(); }
void read_value(const JsonNode& node, double& value) { value = node.number(); }
void read_value(const JsonNode& node, std::optional<double>& value) { value = node.number(); }
void read_value(const JsonNode& node, int& value) { value = static_cast<int>(node.integer()); }
void read_value(const JsonNode& node, bool& value) { value = node.flag(); }
void read_value(const JsonNode& node, std::map<std::string, double>& value) {
  for (const auto& [key, number] : node.members()) value[key] = number.number();
}

template <class T>
Json json_of(const T& value) {
  return value;
}
Json json_of(const std::optional<double>& value) { return *value; }

// One pass over the members of an object, in the order of the file: it reads them or writes them.
class Members {
 public:
  using Description = std::function<void(Members&)>;

  static void read(const JsonNode& node, const Description& describe_members) {
    Members list, reader;
    describe_members(list);
    node.require_spelling(list.known_);
    reader.node_ = &node;
    describe_members(reader);
  }

  static Json written(const Description& describe_members) {
    Members writer;
    writer.json_ = Json::object();
    describe_members(writer);
    return *writer.json_;
  }

  // A member with its own way of reading and writing. An optional one is written if it is given.
  template <class Read, class Write>
  void member(const std::string& key, bool is_required, bool is_given, const Read& read, const Write& write) {
    known_.push_back(key);
    if (json_ && (is_required || is_given)) (*json_)[key] = write();
    if (node_ == nullptr) return;
    if (is_required)
      read(node_->at(key));
    else if (const auto found = node_->find(key))
      read(*found);
  }

  template <class T>
  void required(const std::string& key, T& value) {
    member(
        key, true, true, [&](const JsonNode& node) { read_value(node, value); },
        [&] { return json_of(value); });
  }
  // Left out if it is empty, false or 0.
  template <class T>
  void optional(const std::string& key, T& value) {
    member(
        key, false, value != T(), [&](const JsonNode& node) { read_value(node, value); },
        [&] { return json_of(value); });
  }
  // One of several words, in the order of an enumeration.
  template <class Enum, std::size_t N>
  void word(const std::string& key, Enum& value, const std::array<std::string_view, N>& names) {
    member(
        key, true, true,
        [&](const JsonNode& node) {
          value = static_cast<Enum>(node.one_of({names.begin(), names.end()}));
        },
        [&] { return names[static_cast<std::size_t>(value)]; });
  }
  // A word that a reader may do without.
  void constant(const std::string& key, const std::string& value) {
    member(
        key, false, true, [&](const JsonNode& node) { static_cast<void>(node.one_of({value})); },
        [&] { return value; });
  }
  // An object that is kept as its text.
  void json(const std::string& key, std::string& text, bool is_required) {
    member(
        key, is_required, !text.empty(),
        [&](const JsonNode& node) {
          if (!node.value().is_object()) node.fail_unless("an object");
          text = node.value().dump();
        },
        [&] { return Json::parse(text); });
  }

  void object(const std::string& key, const Description& describe_members, bool is_required = true,
              bool is_given = true) {
    member(
        key, is_required, is_given, [&](const JsonNode& node) { read(node, describe_members); },
        [&] { return written(describe_members); });
  }
  template <class T>
  void optional(const std::string& key, std::optional<T>& value, void (*describe_members)(Members&, T&)) {
    T item = value.value_or(T());
    object(
        key, [&](Members& members) { describe_members(members, item); }, false, value.has_value());
    if (node_ != nullptr && node_->find(key)) value = item;
  }
  template <class T>
  void objects(const std::string& key, std::vector<T>& items, void (*describe_members)(Members&, T&),
               bool is_required = true) {
    const auto of = [describe_members](T& item) {
      return [describe_members, &item](Members& members) { describe_members(members, item); };
    };
    member(
        key, is_required, !items.empty(),
        [&](const JsonNode& node) {
          for (const JsonNode& element : node.elements()) read(element, of(items.emplace_back()));
        },
        [&] {
          Json array = Json::array();
          for (T& item : items) array.push_back(written(of(item)));
          return array;
        });
  }

  // Keys of other programs.
  void also(const std::vector<std::string>& keys) { known_.insert(known_.end(), keys.begin(), keys.end()); }

 private:
  const JsonNode* node_{};
  std::optional<Json> json_;
  std::vector<std::string> known_;
};

// --- the members of each struct

void describe_members(Members& members, Field& field) {
  constexpr std::array<std::string_view, 3> types{"string", "integer", "number"};
  members.required("name", field.name);
  members.word("type", field.type, types);
  members.optional("unit", field.unit);
  members.optional("description", field.description);
  members.member(
      "class", false, field.value_class.has_value(),
      [&](const JsonNode& node) {
        field.value_class =
            static_cast<ValueClass>(node.one_of({value_class_names.begin(), value_class_names.end()}));
      },
      [&] { return to_string(*field.value_class); });
  members.object(
      "constraints",
      [&](Members& constraints) {
        constraints.optional("required", field.required);
        constraints.optional("enum", field.allowed);
        constraints.also({"unique", "minimum", "maximum", "minLength", "maxLength", "pattern"});
      },
      false, field.required || !field.allowed.empty());
  members.also({"title", "format"});
}

void describe_members(Members& members, ForeignKey& key) {
  members.required("fields", key.column);
  members.object("reference", [&](Members& reference) {
    reference.required("resource", key.resource);
    reference.required("fields", key.reference_column);
  });
}

void describe_members(Members& members, DecidingValue& value) {
  members.required("field", value.field);
  members.required("threshold", value.threshold);
}

void describe_members(Members& members, ComparedValue& value) {
  members.required("field", value.field);
  members.word("norm", value.norm, norm_names);
  members.required("tolerance", value.tolerance);
  members.optional<DecidingValue>("decided_by", value.decided_by, describe_members);
}

void describe_members(Members& members, Interpolation& interpolation) {
  members.required("order", interpolation.order);
  members.required("error", interpolation.error);
}

void describe_members(Members& members, ComparisonRule& rule) {
  members.word("kind", rule.kind, comparison_kind_names);
  members.objects<ComparedValue>("values", rule.values, describe_members);
  members.optional("abscissa", rule.abscissa);
  members.optional<Interpolation>("interpolation", rule.interpolation, describe_members);
  members.optional("events", rule.events);
  members.optional("horizon", rule.horizon);
  members.optional("shortest_phase", rule.shortest_phase);
}

void describe_members(Members& members, DiagnosisRule& rule) {
  members.required("quantity", rule.quantity);
  const auto of_column = [&](Members& object) { object.required("column", rule.case_column); };
  members.member(
      "case", true, true,
      [&](const JsonNode& node) {
        if (node.value().is_object())
          Members::read(node, of_column);
        else
          rule.case_name = node.text();
      },
      [&] { return rule.case_column.empty() ? Json(rule.case_name) : Members::written(of_column); });
  members.required("abscissa", rule.abscissa);
  members.required("value", rule.value);
}

void describe_members(Members& members, Provenance& provenance) {
  members.word("class", provenance.value_class, value_class_names);
  members.required("method", provenance.method);
  members.json("settings", provenance.settings, true);
  members.required("software", provenance.software);
  members.required("checks", provenance.checks);
}

void describe_schema(Members& members, Resource& resource) {
  members.objects<Field>("fields", resource.fields, describe_members);
  members.member(
      "primaryKey", false, !resource.primary_key.empty(),
      [&](const JsonNode& node) {
        resource.primary_key = node.value().is_string() ? std::vector{node.text()} : node.texts();
      },
      [&] { return resource.primary_key; });
  members.objects<ForeignKey>("foreignKeys", resource.foreign_keys, describe_members, false);
  members.also({"missingValues"});
}

void describe_members(Members& members, Resource& resource) {
  constexpr std::string_view method = "sha256:";
  members.required("name", resource.name);
  members.member(
      "path", true, true, [&](const JsonNode& node) { resource.path = node.text(); },
      [&] { return resource.path.generic_string(); });
  members.constant("profile", "tabular-data-resource");
  members.constant("format", "csv");
  members.constant("mediatype", "text/csv");
  members.constant("encoding", "utf-8");
  members.member(
      "bytes", true, true,
      [&](const JsonNode& node) {
        if (node.integer() < 1) node.fail_unless("an integer above 0");
        resource.bytes = static_cast<std::size_t>(node.integer());
      },
      [&] { return resource.bytes; });
  members.member(
      "hash", true, true,
      [&](const JsonNode& node) {
        const std::string text = node.text();
        resource.sha256 = text.substr(std::min(text.size(), method.size()));
        if (!text.starts_with(method) || resource.sha256.size() != 64 ||
            resource.sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
          node.fail_unless("sha256: and 64 hexadecimal digits");
      },
      [&] { return std::string(method) + resource.sha256; });
  members.required("title", resource.title);
  members.required("description", resource.description);
  members.json("problem", resource.problem, false);
  members.object("schema", [&](Members& schema) { describe_schema(schema, resource); });
  members.optional<ComparisonRule>("comparison", resource.comparison, describe_members);
  members.optional<DiagnosisRule>("diagnosis", resource.diagnosis, describe_members);
  members.object("provenance",
                 [&](Members& provenance) { describe_members(provenance, resource.provenance); });
  members.also({"licenses", "sources", "dialect"});
}

}  // namespace

Resource read_description(const JsonNode& node) {
  Resource resource;
  Members::read(node, [&](Members& members) { describe_members(members, resource); });
  return resource;
}

std::string json_text(Resource resource) {
  return Members::written([&](Members& members) { describe_members(members, resource); }).dump();
}

}  // namespace stickslip::data
