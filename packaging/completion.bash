# bash completion of repose. tests/regression/install_test.py compares it with `repose --help`.

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

# The command, with the tool after thermal, among the words before the one at the cursor.
_repose_command() {
  local word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == -* ]] && break
    command=${command:+$command }$word
    [[ $command == thermal ]] || break
  done
}

_repose() {
  local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=''
  local study='--help --set --output --vector-level --time-limit --quiet' options=''
  _repose_command

  case $previous in
    --output) if [[ $command == export ]]; then _repose_files vtp csv; else _repose_files; fi && return ;;
    --deck) _repose_files toml && return ;;
    --vector-level) _repose_words auto sse2 avx2 avx512 && return ;;
    --format) _repose_words vtp csv && return ;;
    --set | --case | --time-limit) return ;;
  esac

  case $command in
    '') options='--help --version' ;;
    run) options="$study --restart" ;;
    validate) options="$study --case" ;;
    calibrate | sensitivity) options=$study ;;
    check) options='--help --set' ;;
    info | keys | thermal) options='--help' ;;
    export) options='--help --format --output' ;;
    estimate) options='--help --deck' ;;
    thermal\ bed | thermal\ synthesise | thermal\ sensor | thermal\ mixture) options='--help --set --output' ;;
    measure | thermal\ * | compare) options='--help --deck --set --output' ;;
  esac
  if [[ $cur == -* ]]; then
    _repose_words "$options"
    return
  fi

  case $command in
    '') _repose_words run check measure info export validate calibrate estimate sensitivity thermal compare keys ;;
    thermal) _repose_words bed network tps synthesise sensor mixture ;;
    measure | thermal\ network) _repose_files hdf csv ;;
    info) _repose_files hdf h5 ;;
    export) _repose_files hdf ;;
    estimate) _repose_files ;;
    compare | thermal\ tps) _repose_files csv ;;
    keys) ;;
    *) _repose_files toml ;;
  esac
}

complete -F _repose repose
