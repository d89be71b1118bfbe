# Completion of aomd in fish: commands and options are asked of the program.
function __aomd_commands
    aomd --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\)  *\(.*\)/\1\t\2/p'
end
function __aomd_options
    aomd (commandline -opc)[2] --help 2>/dev/null | grep -o -- '^  \(-[a-z],\)\?--[a-z-]*' | grep -o -- '--[a-z-]*'
end
complete -c aomd -n __fish_use_subcommand -f -a '(__aomd_commands)'
complete -c aomd -n 'not __fish_use_subcommand; and string match -q -- "-*" (commandline -ct)' -f -a '(__aomd_options)'
