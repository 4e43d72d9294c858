#!/bin/bash
# manual_test BUILD: the manual page and the completion know every command and every option that --help tells of, and
# no other.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
program=$1/metamer
packaging=$scripts/../packaging
# shellcheck source=packaging/metamer.bash
. "$packaging/metamer.bash"

# options_of COMMAND: its long options as --help has them, one a line.
options_of() {
    # shellcheck disable=SC2086 # a command may be two words
    "$program" $1 --help | sed -n 's/^  \(-[a-z],\)\{0,1\}\(--[a-z][a-z-]*\).*/\2/p' | sort
}

# commands_of COMMAND: those that may follow it.
commands_of() {
    # shellcheck disable=SC2086
    "$program" $1 --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' | sort
}

# section_of COMMAND: its part of the manual, without macros' quotes and escapes.
section_of() {
    sed 's/\\-/-/g; s/\\f[A-Z]//g' "$packaging/metamer.1" | awk -v heading="^[.]SS \"metamer $1( |\"$)" '
        /^[.]S[SH]/ { inside = $0 ~ heading }
        inside'
}

# manual_options COMMAND: the long options that head a paragraph (the line after .TP) there, one a line; --help, which
# every command has, is told once.
manual_options() {
    { echo --help; section_of "$1" | awk 'heads { print } { heads = /^[.]TP/ }' | grep -oE -- '--[a-z][a-z-]*'; } | sort
}

# words: what is given, sorted, one a line.
words() { tr ' ' '\n' | sed '/^$/d' | sort; }

# hold COMMAND: it and those that follow it.
hold() {
    expect "completion of the options of '$1'" "$(options_of "$1")" "$(_metamer_options "$1" | words)"
    expect "completion of the commands of '$1'" "$(commands_of "$1")" "$(_metamer_commands "$1" | words)"
    local after
    after=$(commands_of "$1")
    if [ -z "$after" ] && [[ $1 != "list "* ]]; then
        expect "the manual's options of '$1'" "$(options_of "$1")" "$(manual_options "$1")"
        held=$((held + 1))
    fi
    for command in $after; do
        hold "${1:+$1 }$command"
    done
}
held=0
hold ""
expect "commands with a section" 10 "$held"
for what in $(commands_of list); do
    expect_has "the manual's list" "$what" "$(grep '^[.]SS "metamer list' "$packaging/metamer.1")"
done
expect_has "the manual's version" "\"$("$program" --version)\"" "$(head -n 1 "$packaging/metamer.1")"
expect_has "the changelog's version" "$("$program" --version | sed 's/ \(.*\)/ (\1)/')" "$(head -n 1 "$packaging/changelog")"

# complete WORD...: what may take the last word's place, in one line.
complete_words() {
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _metamer
    echo "${COMPREPLY[*]}"
}
PATH=$1:$PATH
expect "commands" "chart check" "$(complete_words metamer ch)"
expect "after a command" "show" "$(complete_words metamer atlas s)"
expect "an option" "--precision" "$(complete_words metamer plan x.ini --p)"
expect "a lamp's name" "krypton" "$(complete_words metamer measure --lamp kry)"
expect "a material's" "crayon-violet" "$(complete_words metamer measure --material crayon-v)"
expect "a value" "weighted" "$(complete_words metamer atlas build --quantization w)"
touch "$scratch/a.ini" "$scratch/a.png" "$scratch/a.txt"
mkdir "$scratch/a.d"
expect "exhibits and folders" "$scratch/a.ini $scratch/a.d" "$(complete_words metamer run "$scratch/a")"
expect "what can be checked" "$scratch/a.ini $scratch/a.png $scratch/a.txt $scratch/a.d" \
    "$(complete_words metamer check "$scratch/a" | words | paste -s -d ' ' | sed "s|$scratch/a.d \(.*\)|\1 $scratch/a.d|")"
done_expecting
