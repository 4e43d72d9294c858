# bash completion for metamer(1)                                          -*- shell-script -*-

# The options of a command, one a word; tests hold them to the program's --help.
_metamer_options() {
    case $1 in
    "") echo "--help --version" ;;
    run) echo "--help --set --size --wait --describe" ;;
    render) echo "--help --set --output --size --table" ;;
    measure) echo "--help --lamp --material --exhibit --json" ;;
    plan) echo "--help --set --precision --json" ;;
    chart) echo "--help --set --output --rounds --lamps --materials --growth --from --paper" ;;
    stability) echo "--help --output --json" ;;
    "atlas build") echo "--help --lamps --materials --quantization --output" ;;
    "atlas show") echo "--help --picture --json" ;;
    info) echo "--help --json" ;;
    *) echo "--help" ;;
    esac
}

# The words that may follow a command that takes another.
_metamer_commands() {
    case $1 in
    "") echo "run render measure plan chart stability atlas check info list" ;;
    atlas) echo "build show" ;;
    list) echo "lamps materials spaces methods scenes" ;;
    esac
}

# _metamer_names lamps|materials: of the library. Sets stand in brackets, members are indented.
_metamer_names() {
    metamer list "$1" 2>/dev/null | sed 's/^ *\[\{0,1\}\([^] ]*\).*/\1/'
}

_metamer() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command="" i
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case " $(_metamer_commands "$command") " in
        *" ${COMP_WORDS[i]} "*) command="${command:+$command }${COMP_WORDS[i]}" ;;
        *) break ;;
        esac
    done
    local names="" files=""
    case $previous in
    --lamp) names=$(_metamer_names lamps) files='*.csv' ;;
    --material) names=$(_metamer_names materials) files='*.csv' ;;
    --lamps) names="all thesis $(_metamer_names lamps)" files='*.csv' ;;
    --materials) names=$(_metamer_names materials) files='*.csv' ;;
    --precision) names="fp16 fp32" ;;
    --quantization) names="thesis weighted" ;;
    --set | --size | --rounds) return ;;
    --exhibit) files='*.ini' ;;
    --from | --paper) files='*.csv' ;;
    -o | --output | --picture | --describe) files='*' ;;
    *)
        names=$(_metamer_commands "$command")
        case $word in
        -*) names=$(_metamer_options "$command") ;;
        *)
            case $command in
            run | render | plan | chart) files='*.ini' ;;
            "atlas show") files='*.png' ;;
            check) files='*.@(ini|png|csv|txt)' ;;
            esac
            ;;
        esac
        ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$word")
    if [ -n "$files" ]; then
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(
            shopt -s extglob # of the pattern below, which is read when it runs
            compgen -f -X "!$files" -- "$word"
            compgen -d -- "$word"
        )
        compopt -o filenames 2>/dev/null
    fi
}
complete -F _metamer metamer
