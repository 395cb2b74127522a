#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The completions of the shells: what they offer is what weft takes.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

mkdir "$work/place" "$work/place/folder"
cd "$work/place" || exit 1
ln -s "$WEFT" weft
PATH=$work/place:$PATH
export PATH
cp "$WEFT_SOURCE/examples/miura.knit" 'my miura.knit'
cp "$WEFT_SOURCE/examples/miura.knit" rib.knit
touch chart.csv chart.txt notes.md

# Words a help lists: commands, and options of a command.
"$WEFT" help | sed -n '/^Commands:/,/^$/p' | sed '1d; /^$/d; s/^ *\([a-z]*\).*/\1/' | sort >"$work/commands"
options_of() {
    "$WEFT" help "$1" | sed -n '/^Options:/,$p' | sed 1d | cut -c 1-29 | tr ', ' '\n\n' | grep '^-' | sort
}

# offered WORD...: what is offered for the last word, a line each, sorted.
# offers NAME 'WANTED...' WORD...
offers() {
    name=$1
    wanted=$2
    shift 2
    offered "$@" | tr '\n' ' ' >"$work/offered"
    check "$name" test "$(cat "$work/offered")" = "$wanted "
}

all() {
    offered '' | sed '/\.knit$/d; /^folder$/d' >"$work/offered"
    check "$1: every command" diff "$work/commands" "$work/offered"
    check "$1: and scripts" test "$(offered '' | grep -c '\.knit$')" = 2
    offers "$1: a command begun" 'check' che
    while read -r command; do
        offered "$command" - | sed 's/=$//' >"$work/offered"
        options_of "$command" >"$work/options"
        check "$1: options of $command" diff "$work/options" "$work/offered"
    done <"$work/commands"
    offered list '' >"$work/offered"
    "$WEFT" list | sed '1d; s/[ (].*//' | sort >"$work/motifs"
    check "$1: every motif" diff "$work/motifs" "$work/offered"
    offers "$1: a motif begun" 'herringbone' list herr
    offers "$1: scripts and folders" 'folder my miura.knit rib.knit' check ''
    offers "$1: charts to import" 'chart.csv chart.txt folder' import ''
    offers "$1: methods" 'newton' run rib.knit --method ne
    offers "$1: params" 'half=' run rib.knit -D ''
    offers "$1: commands to explain" 'chart check' help ch
    offers "$1: folders" 'folder' check -I ''
    offers "$1: any file to write" 'chart.csv chart.txt' chart rib.knit -o chart
}

# ---- bash ----

if bash -c 'type complete compgen mapfile' >"$work/.check" 2>&1; then
    cat >"$work/offered.bash" <<'BASH'
source "$WEFT_SOURCE/completions/weft.bash"
[[ $(complete -p weft) == *'-F _weft weft' ]] || exit 1
COMP_WORDS=(weft "$@")
COMP_CWORD=$#
_weft weft "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}" | sort -u
BASH
    offered() { bash --norc "$work/offered.bash" "$@"; }
    all bash
    offers 'bash: behind an equal sign' 'newton' run rib.knit --method = ne
    offers 'bash: at an equal sign' 'patch triangle' run rib.knit --discretisation =
    offers 'bash: an option that wants a value' '--method=' rib.knit --meth
    offers 'bash: all sets of words are right' 'human json' check --diagnostics ''
else
    skip 'bash completions' 'bash cannot complete here'
fi

# ---- zsh ----

# What the function hands to zsh's own is printed instead.
if command -v zsh >/dev/null 2>&1; then
    cat >"$work/offered.zsh" <<'ZSH'
compadd() {
  local suffix= from=
  while [[ $1 == -* ]]; do
    case $1 in
      -S) suffix=$2; shift 2 ;;
      -a) from=$2; shift 2 ;;
      --) shift; break ;;
    esac
  done
  [[ -n $from ]] && set -- ${(P)from}
  print -l -- ${^@}$suffix
}
_describe() { print -l -- ${(P)@[-1]} | sed 's/:.*//' }
_message() { }
compset() { words[CURRENT]=${words[CURRENT]#*=} }
_files() {
  if [[ $1 == -g ]]; then print -l -- ${~2}(N) *(N/)
  elif [[ $1 == -/ ]]; then print -l -- *(N/)
  else print -l -- *(N); fi
}
words=(weft "$@")
CURRENT=$#words
source $WEFT_SOURCE/completions/_weft
ZSH
    offered() {
        zsh -f "$work/offered.zsh" "$@" >"$work/zsh" 2>"$work/zsh.err"
        cat "$work/zsh.err"
        for last; do :; done
        sed '/^$/d' "$work/zsh" | awk -v begin="${last#*=}" 'index($0, begin) == 1' | sort -u
    }
    all zsh
    offers 'zsh: behind an equal sign' 'newton' run rib.knit --method=ne
    check 'zsh: it says for which command it is' grep -qx '#compdef weft' "$WEFT_SOURCE/completions/_weft"
else
    skip 'zsh completions' 'zsh is not here'
fi

# Words for values are words the options take.
for word in auto newton plbfgs lbfgs; do
    exits 0 "--method $word" "$WEFT" run rib.knit --dry-run -q --method "$word" -D half=3
done
for word in patch triangle; do
    exits 0 "--discretisation $word" "$WEFT" run rib.knit --dry-run -q --discretisation "$word" -D half=3
done

finish
