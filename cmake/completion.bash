# SPDX-License-Identifier: BSD-3-Clause
# Completion of kanec in bash: commands and options as --help lists them, else files.
_kanec() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [ "$COMP_CWORD" = 1 ] && [ "${word#-}" = "$word" ]; then
    COMPREPLY=($(compgen -W "$(kanec --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')" -- "$word"))
  elif [ "${word#-}" != "$word" ]; then
    [ "$COMP_CWORD" = 1 ] && command=
    COMPREPLY=($(compgen -W "$(kanec $command --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u)" -- "$word"))
  fi
}
complete -o default -o bashdefault -F _kanec kanec
