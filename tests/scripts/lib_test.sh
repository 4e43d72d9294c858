#!/bin/bash
# scripts/lib.sh: a failed step is one line that names the step, the cause and the log; packages come from one list.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
mkdir -p "$scratch/tree/scripts" "$scratch/bin"
cp "$scripts/lib.sh" "$scripts/packages" "$scratch/tree/scripts/"

# in_lib COMMAND: stdout and stderr of COMMAND in a script named `sample` that has sourced the library.
in_lib() {
    printf 'set -euo pipefail\n. "%s/tree/scripts/lib.sh"\n%s\n' "$scratch" "$1" >"$scratch/sample"
    bash "$scratch/sample" 2>&1
}

# fails_with CAUSE LOG: a step whose command prints LOG (printf's language) and fails.
fails_with() {
    expect "cause in $2" \
        "$(printf 'sample: build it\nsample: cannot build it: %s (the full log: %s)' "$1" "$scratch/tree/out/logs/sample-x.log")" \
        "$(in_lib "say() { printf '$2'; return 7; }; step x 'build it' say; echo not reached")"
}
fails_with "a.cpp:3:1: error: bad thing" 'Looking for it - not found\na.cpp:3:1: error: bad thing\n   3 | bad\n'
fails_with "CMake Error at CMakeLists.txt:3: there is no glm" 'CMake Error at CMakeLists.txt:3:\n\n  there is no glm\n\n  more'
fails_with "E: Unable to locate package x" 'Reading...\nE: Unable to locate package x\nmore\n'
fails_with "metamer: cannot read a.ini: gone" 'metamer: cannot read a.ini: gone\nmore\n'
fails_with "last words" 'first\nlast words\n\n'
fails_with "it said nothing" ''

in_lib "step x 'build it' false" >/dev/null
expect "exit status of a failed step" 1 $?

expect "a good step is one line" "sample: build it" "$(in_lib "step x 'build it' echo done")"
expect "its log" "done" "$(cat "$scratch/tree/out/logs/sample-x.log")"
expect "a step runs in the tree" "$scratch/tree" \
    "$(cd / && in_lib "step x y pwd" >/dev/null; cat "$scratch/tree/out/logs/sample-x.log")"

# A machine that has only cmake, and of ninja-build the configuration alone.
cat >"$scratch/bin/dpkg-query" <<'QUERY'
#!/bin/bash
echo "installed cmake"
echo "config-files ninja-build"
exit 1
QUERY
printf '#!/bin/bash\necho 1000\n' >"$scratch/bin/id"
chmod +x "$scratch/bin/dpkg-query" "$scratch/bin/id"
for tool in bash basename dirname readlink awk sed grep paste mkdir; do
    ln -s "$(command -v $tool)" "$scratch/bin/$tool"
done
printf '# a\ng++ build x\ncmake build x\nninja-build build x\nlibegl1 run x\nlibgtest-dev test x\n' \
    >"$scratch/tree/scripts/packages"
expect "neither root nor sudo" \
    "sample: cannot install packages: neither root nor sudo; as root: apt-get install g++ ninja-build libegl1" \
    "$(PATH=$scratch/bin in_lib "install_packages build run")"

printf '#!/bin/bash\necho "$*" >>"%s/asked"\necho "Setting up x"\n' "$scratch" | tee "$scratch/bin/env" >"$scratch/bin/sudo"
chmod +x "$scratch/bin/sudo" "$scratch/bin/env"
apt="DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120"
asked="$apt update
$apt install -y --no-install-recommends g++ ninja-build libegl1"
said=$(PATH=$scratch/bin in_lib "install_packages build run")
expect_has "what is missing" "sample: missing: g++ ninja-build libegl1" "$said"
expect_has "how many came" "... 1 packages, listed in out/logs/sample-apt-install.log" "$said"
expect "who is not root asks sudo" "env ${asked//$'\n'/$'\n'env }" "$(cat "$scratch/asked")"
printf '#!/bin/bash\necho 0\n' >"$scratch/bin/id"
rm "$scratch/bin/sudo" "$scratch/asked"
PATH=$scratch/bin in_lib "install_packages build run" >/dev/null
expect "root asks nobody" "$asked" "$(cat "$scratch/asked")"
expect "nothing missing" "" "$(printf 'cmake build x\n' >"$scratch/tree/scripts/packages"; PATH=$scratch/bin in_lib "install_packages build")"
rm "$scratch/bin/dpkg-query"
expect_has "no dpkg" "taking for granted" "$(PATH=$scratch/bin in_lib "install_packages build")"

# screen STATUS [TERMINAL] [VARIABLE=VALUE]: where a window is tried with one connector in this state.
screen() {
    mkdir -p "$scratch/sys/class/drm/card0-HDMI-A-1"
    echo "$1" >"$scratch/sys/class/drm/card0-HDMI-A-1/status"
    env -u DISPLAY -u WAYLAND_DISPLAY "${3:-A=B}" bash -c \
        "set -euo pipefail; . '$scripts/lib.sh'; display_here '$scratch/sys' '${2:-/dev/tty1}'"
}
expect "a console with a screen" console "$(screen connected)"
expect "a console without one" "" "$(screen disconnected)"
expect "a terminal that is not the machine's own" "" "$(screen connected /dev/pts/3)"
expect "no terminal at all" "" "$(screen connected "not a tty")"
expect "X" desktop "$(screen disconnected /dev/pts/3 DISPLAY=:0)"
expect "Wayland" desktop "$(screen disconnected /dev/pts/3 WAYLAND_DISPLAY=wayland-0)"

expect "every package has a group and a reason" "" \
    "$(awk '!/^#/ && (NF < 3 || $2 !~ /^(build|run|test|ci|bench|docs|fuzz|package)$/)' "$scripts/packages")"
done_expecting
