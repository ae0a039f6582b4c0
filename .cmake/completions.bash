# Completion of bash for birdstrike: commands, options of a command as its --help lists them, files.
_birdstrike()
{
  local word=${COMP_WORDS[COMP_CWORD]}
  local before=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  *.*/\1/p') --help --version" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE '^ *(-h,)?--[a-z-]+' | sed 's/.*--/--/')" -- "$word")
  elif [[ ${COMP_WORDS[1]} == resume || $before == --output ]]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$word"; compgen -d -S / -- "$word")
  fi
}
complete -o nospace -o filenames -F _birdstrike birdstrike
