# Completion of stickslip for fish: the program says what may follow. Where it says nothing, files may.
function __stickslip_complete
    set -l candidates (stickslip complete -- (commandline -opc)[2..-1] (commandline -ct) 2>/dev/null)
    if test -n "$candidates"
        printf '%s\n' $candidates
    else
        __fish_complete_path (commandline -ct)
    end
end

complete -c stickslip -f -a '(__stickslip_complete)'
