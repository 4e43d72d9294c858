# shellcheck shell=bash disable=SC2034 # its variables are for those who source it
# What the tests of the scripts share: a scratch folder that goes with the test, and expectations.

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# expect WHAT EXPECTED ACTUAL: equal as text.
expect() {
    [ "$2" = "$3" ] && return
    printf '%s:\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3" >&2
    failures=$((failures + 1))
}

# expect_has WHAT PART TEXT
expect_has() {
    case $3 in
    *"$2"*) ;;
    *) expect "$1" "...$2..." "$3" ;;
    esac
}

# done_expecting: ends the test.
done_expecting() {
    [ "$failures" = 0 ] || exit 1
}
