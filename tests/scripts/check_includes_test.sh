#!/bin/bash
# scripts/check-includes takes this tree, and refuses by name what goes against the light.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"

expect "this tree" "check-includes: fine" "$("$scripts/check-includes" 2>&1)"

# house: a tree of three rooms and a GL one.
house() {
    rm -rf "$scratch/src"
    mkdir -p "$scratch"/src/{base,color,gles,render}
    echo 'foreach(room base color gles render)' >"$scratch/src/CMakeLists.txt"
    echo '#include "base/error.h"' >"$scratch/src/color/xyz.h"
    echo '#include <GLES2/gl2.h>' >"$scratch/src/gles/texture.h"
    printf '#include "color/xyz.h"\n  #  include "gles/texture.h"\n#include <GLES2/gl2.h>\n' >"$scratch/src/render/frame.cpp"
    echo 'metamer_room(color SOURCES a.cpp LINKS metamer_base metamer_flags)' >"$scratch/src/color/CMakeLists.txt"
}

# refuses FILE LINE SENTENCE: the house with LINE added as the second of FILE.
refuses() {
    house
    printf '\n%s\n' "$2" >"$scratch/src/$1"
    local said
    said=$("$scripts/check-includes" "$scratch" 2>&1) && expect "exit status with $2 in $1" "not 0" 0
    expect "$2 in $1" "src/$1:$3" "$said"
}

house
expect "a good house" "check-includes: fine" "$("$scripts/check-includes" "$scratch" 2>&1)"
refuses color/a.cpp '#include "render/frame.h"' "2: color may not know render, which is below it"
refuses gles/a.h '#include "color/xyz.h"' "2: gles may not know color"
refuses color/a.h '#include "xyz.h"' '2: "xyz.h" is not room/file.h'
refuses color/a.h '#include "colors/xyz.h"' '2: "colors/xyz.h" is not room/file.h'
refuses color/a.cpp '#include <GLES2/gl2.h>' "2: color knows no GL"
refuses base/a.cpp '#include <EGL/egl.h>' "2: base knows no GL"
refuses color/CMakeLists.txt 'LINKS metamer_base metamer_gles)' "2: color may not know gles, which is below it"
mkdir "$scratch/src/attic"
: >"$scratch/src/CMakeLists.txt"
expect "no rooms" "check-includes: cannot find the rooms in src/CMakeLists.txt" "$("$scripts/check-includes" "$scratch" 2>&1)"
done_expecting
