# bash completion of repose. Commands, options, choices and the endings of files are those that `repose --help` tells.

# Names of files with one of these endings, and of directories.
_repose_files() {
  local ending
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(
    compgen -d -- "$cur"
    for ending in "$@"; do compgen -f -X "!*.$ending" -- "$cur"; done | sort -u
  )
}

_repose_words() { mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur"); }

# Lines of the help below a heading.
_repose_section() { sed -n "/^$1:/,/^[A-Z][A-Za-z]*:/p" <<<"$help" | grep '^  *[^ ]'; }

# The endings of files that a description names: "(TOML)", "(.hdf)", "grid.h5", "CSV".
_repose_endings() { grep -oE '\bTOML\b|\bCSV\b|\.(hdf|h5)\b' <<<"$*" | tr -d . | tr '[:upper:]' '[:lower:]' | sort -u; }

_repose() {
  local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} help line word
  local -a command=() endings=()
  help=$("${COMP_WORDS[0]}" --help 2>/dev/null) || return
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == -* ]] && break
    _repose_section Subcommands | awk '{print $1}' | grep -qxF -- "$word" || break
    command+=("$word")
    help=$("${COMP_WORDS[0]}" "${command[@]}" --help 2>/dev/null) || return
  done

  line=$(_repose_section Options | grep -E "^ *(-[a-z],)?$previous( |$)" | head -n 1)
  if [[ $previous == --* && -n $line ]]; then
    if [[ $line == *'{'* ]]; then
      word=${line#*\{}
      _repose_words "$(tr ',' ' ' <<<"${word%%\}*}")" && return
    fi
    case $line in
      *' DIR '*) _repose_files && return ;;
      *' DECK '*) _repose_files toml && return ;;
      *' FILE '*) _repose_files toml csv vtp dump && return ;;
      *KEY=VALUE* | *NAME* | *HH:MM:SS*) return ;;
    esac
  fi

  if [[ $cur == -* ]]; then
    _repose_words "$(_repose_section Options | grep -oE -- '--[a-z-]+' | sort -u)"
  elif [[ $help == *Subcommands:* ]]; then
    _repose_words "$(_repose_section Subcommands | grep -E '^  [a-z]' | awk '{print $1}')"
  else
    line=$(_repose_section Positionals)
    if [[ $line == *LIGGGHTS* ]]; then # whose scripts have names of any kind
      mapfile -t COMPREPLY < <(compgen -f -- "$cur")
    elif [[ $line == *TEST* ]]; then
      _repose_words "$("${COMP_WORDS[0]}" new | awk '{print $1}')"
    else
      mapfile -t endings < <(_repose_endings "$line")
      _repose_files "${endings[@]}"
    fi
  fi
}

complete -F _repose repose
