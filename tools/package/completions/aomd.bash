# Completion of aomd in bash: commands, options and words of options are asked of the program.
_aomd() {
  local cur prev words cword
  _init_completion || return
  if ((cword == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "--help --version $("$1" --help |
      sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p')" -- "$cur")
    return
  fi
  local help
  help=$("$1" "${words[1]}" --help 2>/dev/null) || return
  local choices
  choices=$(sed -n "s/^  $prev \([^ =]*|[^ =]*\).*/\1/p" <<<"$help" | tr '|' '\n' | grep '^[a-z]')
  if [[ $prev == --to ]]; then
    _filedir -d
  elif [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(grep -o -- '^  \(-[a-z],\)\?--[a-z-]*' <<<"$help" |
      grep -o -- '--[a-z-]*')" -- "$cur")
  elif [[ -n $choices ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$cur")
  elif [[ ${words[1]} == sample && cword -eq 2 ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$1" sample --list | cut -d' ' -f1)" -- "$cur")
  else
    _filedir
  fi
}
complete -F _aomd aomd
complete -F _longopt aomd-view
