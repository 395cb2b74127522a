# SPDX-License-Identifier: GPL-3.0-or-later
# Completions of weft for bash.  Commands, options and motifs are asked of weft
# itself, so that they are always those of the version that is installed.

# Lines of `weft help` below a heading up to the next empty one.
_weft_help() {
    "$1" help $3 2>/dev/null | sed -n "/^$2:/,/^\$/p" | sed '1d'
}

_weft_commands() {
    _weft_help "$1" Commands '' | awk '{ print $1 }'
}

# "-q" and "--quiet", with "=" behind those of two dashes that want a value.
_weft_options() {
    _weft_help "$1" Options "$2" | sed 's/^\(.\{28\}\).*/\1/' | tr -d , |
        awk '{ for (i = 1; i <= NF; i++) if ($i ~ /^-/) print $i ($i ~ /^--/ && i < NF ? "=" : "") }'
}

_weft_motifs() {
    "$1" list 2>/dev/null | sed '1d; s/[ (].*//'
}

# The params of the script on the command line, ready for a value.
_weft_params() {
    local word
    for word in "${COMP_WORDS[@]:1}"; do
        [[ $word == *.knit && -f $word ]] && "$1" params "$word" 2>/dev/null | sed 's/ .*/=/'
    done
}

# Adds the words of $1 that begin with $2.
_weft_words() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$2")
}

# Adds folders, and files with one of the extensions $1 ("knit" or "txt|csv"); without: all files.
_weft_files() {
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    if [[ $1 ]]; then
        COMPREPLY+=($(compgen -d -- "$2") $(compgen -f -- "$2" | grep -E "\.($1)\$"))
    else
        COMPREPLY+=($(compgen -f -- "$2"))
    fi
}

# The value of an option; fails where there is none to complete.
_weft_value() {
    case $1 in
        --method) _weft_words 'auto newton plbfgs lbfgs' "$2" ;;
        --discretisation) _weft_words 'patch triangle' "$2" ;;
        --per-stitch) _weft_words 'auto 1 2 4' "$2" ;;
        --color) _weft_words 'auto always never' "$2" ;;
        --diagnostics) _weft_words 'human json' "$2" ;;
        -W) _weft_words error "$2" ;;
        -D) compopt -o nospace 2>/dev/null; _weft_words "$(_weft_params "$3")" "$2" ;;
        -I) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
        -o) _weft_files '' "$2" ;;
        --start) _weft_files state "$2" ;;
        -j | --accuracy | --steps | --seed | --seeds | --key) ;;
        *) return 1 ;;
    esac
}

# The first word that is a command, or "run" behind the name of a script.
_weft_command() {
    local i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in
            -*) ;;
            *.knit) echo run; return ;;
            *) echo "${COMP_WORDS[i]}"; return ;;
        esac
    done
}

_weft() {
    local weft=$1 cur=$2 before=$3 command
    COMPREPLY=()

    # bash takes --name=value for three words.
    if [[ ${COMP_WORDS[COMP_CWORD]} == = ]]; then
        cur=
    elif [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    _weft_value "$before" "$cur" "$weft" && return

    command=$(_weft_command)
    if [[ $cur == -* ]]; then
        _weft_words "$(_weft_options "$weft" "${command:-run}")" "$cur"
        [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
        return
    fi
    case $command in
        '') _weft_words "$(_weft_commands "$weft")" "$cur"; _weft_files knit "$cur" ;;
        help) _weft_words "$(_weft_commands "$weft")" "$cur" ;;
        list) _weft_words "$(_weft_motifs "$weft")" "$cur" ;;
        import) _weft_files 'txt|csv|tsv|png|k|ks' "$cur" ;;
        version) ;;
        *) _weft_files knit "$cur" ;;
    esac
}

complete -F _weft weft
