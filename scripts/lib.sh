# shellcheck shell=bash
# What scripts/demo, scripts/test and .ci/run share: the step that says in one line what failed, and the packages.
# Source it after `set -euo pipefail`. Sets `top` (the source tree) and `me` (the script's name).

top=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
me=$(basename "$0")
export LC_ALL=C.UTF-8 # the causes below are looked for in English

# fail SENTENCE...: one line on stderr, and the end.
fail() {
    echo "$me: $*" >&2
    exit 1
}

# cause LOG: the line of a log that says best what went wrong, joined with the next where it ends in a colon.
cause() {
    local first='^E: |^metamer: |[Ee]rror: |^CMake Error|undefined reference|: No such file|command not found'
    local line
    line=$(awk -v first="$first" '
        { sub(/[ \t]+$/, "") }
        /[^ \t]/ { last = $0; if (said ~ /:$/) { sub(/^[ \t]+/, ""); said = said " " $0 } }
        said == "" && $0 ~ first { said = $0 }
        END { print said != "" ? said : last }' "$1")
    line=${line//"$top/"/}
    printf '%.240s\n' "${line:-it said nothing}"
}

# step NAME WHAT COMMAND...: runs COMMAND with its output in out/logs/; prints `WHAT`, or that it cannot.
step() {
    local name=$1 what=$2 began=$SECONDS status=0
    shift 2
    local log=out/logs/$me-$name.log
    mkdir -p "$top/out/logs" || fail "cannot $what: no folder for its log"
    echo "$me: $what"
    (cd "$top" && "$@") >"$top/$log" 2>&1 </dev/null || status=$?
    [ "$status" = 0 ] || fail "cannot $what: $(cause "$top/$log") (the full log: $top/$log)"
    [ $((SECONDS - began)) -lt 10 ] || echo "$me: ... took $((SECONDS - began)) s"
}

# packages_of GROUP...: the packages of these groups, one a line.
packages_of() {
    awk -v groups=" $* " '!/^#/ && index(groups, " " $2 " ") { print $1 }' "$top/scripts/packages"
}

# missing_of PACKAGE...: those not installed, one a line.
missing_of() {
    local installed
    # dpkg-query fails when it does not know one of them; what it knows it prints all the same.
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
        sed -n 's/^installed //p') || true
    printf '%s\n' "$@" | grep -vxF "$installed" || true
}

# install_packages GROUP...: what is missing of these groups, through apt.
install_packages() {
    local missing as_root=()
    if ! command -v dpkg-query >/dev/null; then
        echo "$me: no dpkg here; taking for granted what scripts/packages lists"
        return
    fi
    # shellcheck disable=SC2046 # one word per package is meant
    missing=$(missing_of $(packages_of "$@") | paste -s -d ' ')
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null ||
            fail "cannot install packages: neither root nor sudo; as root: apt-get install $missing"
        as_root=(sudo)
    fi
    echo "$me: missing: $missing"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
    step apt-update "read apt's lists" "${apt[@]}" update
    # shellcheck disable=SC2086 # one word per package is meant
    step apt-install "install them, and what they need" "${apt[@]}" install -y --no-install-recommends $missing
    echo "$me: ... $(grep -c '^Setting up ' "$top/out/logs/$me-apt-install.log") packages, listed in" \
        "out/logs/$me-apt-install.log"
}

# jobs: compilers at once: one a core, and a gigabyte of memory for each.
jobs_at_once() {
    local cores memory
    cores=$(nproc)
    memory=$(awk '$1 == "MemAvailable:" { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null) || true
    memory=${memory:-$cores}
    [ "$memory" -ge 1 ] || memory=1
    echo $((cores < memory ? cores : memory))
}

# display_here [SYS] [TERMINAL]: where a window can be tried: `desktop`, `console` (this terminal is the machine's own,
# and a screen is plugged in), or nothing.
display_here() {
    local sys=${1:-/sys} terminal=${2:-$(tty 2>/dev/null)}
    if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
        echo desktop
    elif [[ $terminal =~ ^/dev/tty[0-9]+$ ]] && grep -qsx connected "$sys"/class/drm/*/status; then
        echo console
    fi
}
