#!/bin/bash
# curators_test BUILD: every example of docs/curators.md does what the page says.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
top=$(dirname "$scripts") metamer=$1/metamer
cd "$scratch" || exit 1

# A block after `<!-- file: NAME -->` is that file.
awk '/^<!-- file: .* -->$/ { name = $3; next }
     /^```/ { writing = name != "" && !writing; if (!writing) name = ""; next }
     writing { print > name }' "$top/docs/curators.md"
expect "its files" "glaze.csv lamp.ini language.ini objects.ini screen.ini tour-materials.ini tour.ini workshop.csv" \
    "$(printf '%s\n' * | paste -s -d ' ')"
expect "the lamp's table" 2 "$(awk -F, 'NR == 1 { print NF }' workshop.csv)"

# The words, as the page tells to make them.
cp -r "$top/config/strings" .
sed -e 's/^name = English/name = Italiano/' -e 's/^\[lamp\]/&\nworkshop.csv = Neon del laboratorio/' \
    strings/en.ini >strings/it.ini

# opens FILE: exit 3 is a good exhibit that finds no display; what is wrong with it would be exit 2, and come first.
opens() {
    env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=none "$metamer" run "$1" >log 2>&1
    [ $? = 3 ] || expect "run $1" "exit 3, no display" "$(cat log)"
}
for file in *.ini *.csv strings/it.ini; do
    "$metamer" check "$file" >log 2>&1 || expect "check $file" "exit 0" "$(cat log)"
done
for file in *.ini; do
    opens "$file"
done

sed -i '/^close = /d' strings/it.ini
expect_has "a word that is missing" 'it.ini: "button.close" is missing; English: "Close"' \
    "$("$metamer" check language.ini 2>&1)"
sed 's/^lamp = D65/lamp = F2/' tour.ini >other.ini
expect_has "a lamp that is not on the shelf" "lamp = F2 is not on the shelf" "$("$metamer" check other.ini 2>&1)"

done_expecting
