# SPDX-License-Identifier: BSD-3-Clause
# Completion of bagnold for bash. Commands, options and their values are what the program's own help lists.

_bagnold_help() { "$@" --help 2>/dev/null </dev/null; }

# The commands that `bagnold --help` lists.
_bagnold_commands() {
  _bagnold_help "$1" | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p'
}

# The options of a command, or of the program.
_bagnold_options() {
  _bagnold_help "$@" | sed -n '/^Options:/,/^[A-Z][a-z]*:$/!b;s/^  \(-[a-z],\)\{0,1\}\(--[a-z][a-z-]*\).*/\2/p'
}

# The values of an option, where the help gives them in braces.
_bagnold_values() {
  local option="$1"
  shift
  _bagnold_help "$@" | sed -n "s/^  $option [A-Z]*:{\([^}]*\)}.*/\1/p" | tr ',' '\n'
}

# The kinds of analysis, below "Kinds of analysis".
_bagnold_kinds() {
  _bagnold_help "$1" analyse | sed -n '/^Kinds of analysis/,/^Written/s/^  \([a-z][a-z-]*\) .*/\1/p'
}

# The figures of the papers, of an installed program or in the repository.
_bagnold_figures() {
  "$1" figure 2>/dev/null </dev/null | sed -n 's/^\(P[12]-[0-9]*\) .*/\1/p'
}

_bagnold() {
  local program="${COMP_WORDS[0]}" word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD - 1]}"
  local command="" place=0 index offered=""
  COMPREPLY=()
  for ((index = 1; index < COMP_CWORD; ++index)); do
    case "${COMP_WORDS[index]}" in
      -*) ;;
      *) if [ -z "$command" ]; then command="${COMP_WORDS[index]}"; else place=$((place + 1)); fi ;;
    esac
  done

  if [ -z "$command" ] || [ "$command" = help ]; then
    case "$word" in
      -*) offered="$(_bagnold_options "$program")" ;;
      *) offered="$(_bagnold_commands "$program") help" ;;
    esac
  elif [[ "$before" = --* ]] && offered="$(_bagnold_values "$before" "$program" "$command")" && [ -n "$offered" ]; then
    :
  else
    case "$command:$word" in
      *:-*) offered="$(_bagnold_options "$program" "$command")" ;;
      analyse:*) [ "$place" != 0 ] || offered="$(_bagnold_kinds "$program")" ;;
      figure:*) [ "$place" != 0 ] || offered="$(_bagnold_figures "$program")" ;;
    esac
  fi
  # Nothing to offer: names of files (complete -o default).
  mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word")
}

complete -o default -F _bagnold bagnold
