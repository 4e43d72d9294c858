#!/bin/bash
# scripts/tree.sh: a tree is never made over somebody's folder, nor used or removed while something is mounted in it.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"

# with_tree COMMAND: stdout and stderr of COMMAND in a script named `sample` that has sourced the libraries, where
# everybody is root.
with_tree() {
    printf 'set -euo pipefail\n. "%s/lib.sh"\n. "%s/tree.sh"\nid() { echo 0; }\n%s\n' "$scripts" "$scripts" "$1" \
        >"$scratch/sample"
    bash "$scratch/sample" 2>&1
}

cat >"$scratch/mounts" <<'MOUNTS'
/dev/sda1 / ext4 rw 0 0
devtmpfs /t/a/dev devtmpfs rw 0 0
proc /t/a\040b/proc proc rw 0 0
tmpfs /t/ab tmpfs rw 0 0
MOUNTS
expect "mounts below a folder" "/t/a/dev" "$(with_tree "mounted_below /t/a '$scratch/mounts'")"
expect "mounts below a folder with another spelling" "/t/a/dev" "$(with_tree "mounted_below /t/x/../a/ '$scratch/mounts'")"
expect "mounts below a name with a space" '/t/a\040b/proc' "$(with_tree "mounted_below '/t/a b' '$scratch/mounts'")"
expect "a folder that is a mount" "/t/ab" "$(with_tree "mounted_below /t/ab '$scratch/mounts'")"
expect "no mounts" "" "$(with_tree "mounted_below /t/b '$scratch/mounts'")"
expect "this machine's /proc" "/proc" "$(with_tree "mounted_below /proc | grep -x /proc | sort -u")"

expect "not root" "sample: cannot make a Debian tree: chroot and mount need root" \
    "$(with_tree "id() { echo 1000; }; tree_make '$scratch/new'")"
expect "something is mounted" "sample: cannot use $scratch/new: mounted there: /x /y; umount it" \
    "$(with_tree "mounted_below() { printf '/x\n/y\n'; }; tree_make '$scratch/new'")"

mkdir -p "$scratch/mine/etc"
echo 12 >"$scratch/mine/etc/debian_version"
expect "somebody's folder" \
    "sample: cannot make a Debian tree in $scratch/mine: it is neither empty nor a tree that was finished" \
    "$(with_tree "tree_make '$scratch/mine'")"
expect "it stays as it was" 12 "$(cat "$scratch/mine/etc/debian_version")"

mkdir -p "$scratch/tree/dev"
touch "$scratch/tree/.whole"
expect "a tree without devices" \
    "sample: cannot use $scratch/tree: it has no /dev/null of its own; make the tree where mknod is allowed" \
    "$(with_tree "tree_make '$scratch/tree'")"
expect "a kept tree stays" yes "$([ -e "$scratch/tree/.whole" ] && echo yes)"
expect "a scratch tree with a mount is kept" "sample: cannot remove $scratch/tree: something is mounted in it" \
    "$(with_tree "mounted_below() { echo /x; }; tree=$scratch/tree tree_is_scratch=yes; tree_leave")"
expect "it is there" yes "$([ -e "$scratch/tree/.whole" ] && echo yes)"
expect "a scratch tree goes" "" "$(with_tree "tree=$scratch/tree tree_is_scratch=yes; tree_leave")"
expect "it is gone" no "$([ -e "$scratch/tree" ] && echo yes || echo no)"

# What a command in the tree asks of the kernel: /proc and the sources, in a namespace of its own; never /dev.
# shellcheck disable=SC2016 # the dollars are for the stand-ins
asked=$(with_tree 'unshare() { echo "unshare $1 $2 $3"; shift 3; PATH=$bin:$PATH "$@"; }
    bin=$(mktemp -d)
    printf "#!/bin/sh\necho mount \"\$@\"\n" >"$bin/mount"
    printf "#!/bin/sh\necho chroot \"\$1\"\n" >"$bin/chroot"
    chmod +x "$bin"/*
    tree=/t/a top=/t/src
    in_tree true
    rm -r "$bin"')
expect "what is mounted" "unshare --mount --propagation private
mount -t proc proc /t/a/proc
mount --bind /t/src /t/a/src
mount -o remount,bind,ro /t/a/src
chroot /t/a" "$asked"

done_expecting
