# shellcheck shell=bash disable=SC2154 # top is lib.sh's
# What scripts/package-test and scripts/armhf share: a Debian 12 of their own in a folder, so that this machine
# stays as it is. Source it after scripts/lib.sh. Needs root (chroot, mount).
#
# Nothing is ever mounted in the tree as this machine sees it: every command brings /proc and the sources in a mount
# namespace of its own, which ends with the command, even one that is killed. /dev is the tree's, with debootstrap's few
# nodes; this machine's own is never bound there, so that no `rm -rf TREE` can empty it.

# tree_make TREE: a bare Debian 12 in the folder TREE, unless there is one: a copy of the folder BARE where the
# environment names one (debootstrap's result), else debootstrap's. TREE must be empty, missing, or an earlier call's.
tree_make() {
    tree=$1
    [ "$(id -u)" = 0 ] || fail "cannot make a Debian tree: chroot and mount need root"
    trap tree_leave EXIT
    local mounted
    mounted=$(mounted_below "$tree" | paste -s -d ' ')
    [ -z "$mounted" ] || fail "cannot use $tree: mounted there: $mounted; umount it"
    if [ ! -e "$tree/.whole" ]; then
        mkdir -p "$tree"
        [ -z "$(ls -A "$tree")" ] || fail "cannot make a Debian tree in $tree: it is neither empty nor a tree that was finished"
        if [ -n "${BARE:-}" ]; then
            step copy "copy $BARE to $tree" cp -a --one-file-system "$BARE/." "$tree/"
        else
            command -v debootstrap >/dev/null || fail "cannot make a Debian tree: no debootstrap; apt-get install debootstrap"
            step debootstrap "make a bare Debian 12 in $tree" unshare --mount debootstrap --variant=minbase bookworm "$tree"
        fi
        # Nothing that is installed starts in here.
        printf '#!/bin/sh\nexit 101\n' >"$tree/usr/sbin/policy-rc.d"
        chmod +x "$tree/usr/sbin/policy-rc.d"
        mkdir -p "$tree/src"
        touch "$tree/.whole"
    fi
    [ -c "$tree/dev/null" ] || fail "cannot use $tree: it has no /dev/null of its own; make the tree where mknod is allowed"
    cp -L --remove-destination /etc/resolv.conf "$tree/etc/resolv.conf"
    cp /etc/apt/apt.conf.d/*prox* "$tree/etc/apt/apt.conf.d/" 2>/dev/null || true
}

# tree_leave: removes the tree where tree_is_scratch says so, and nothing is mounted in it.
tree_leave() {
    [ -n "${tree_is_scratch:-}" ] || return 0
    if [ -n "$(mounted_below "$tree")" ]; then
        echo "$me: cannot remove $tree: something is mounted in it" >&2
    else
        rm -rf --one-file-system "$tree"
    fi
}

# mounted_below FOLDER [MOUNTS]: where something is mounted in FOLDER or on it, one place a line, with spaces as \040.
# MOUNTS: a table as /proc/self/mounts, the default.
mounted_below() {
    local folder
    folder=$(readlink -m "$1")
    folder=${folder// /\\040} awk '{ at = ENVIRON["folder"] } $2 == at || index($2, at "/") == 1 { print $2 }' \
        "${2:-/proc/self/mounts}"
}

# in_tree COMMAND...: as root in the tree, with nothing of this machine's environment but its proxy; the sources are at
# /src, read-only.
in_tree() {
    # shellcheck disable=SC2016 # the dollars are for the inner shell
    unshare --mount --propagation private sh -euc '
        tree=$1
        mount -t proc proc "$tree/proc"
        mount --bind "$2" "$tree/src"
        mount -o remount,bind,ro "$tree/src"
        shift 2
        exec chroot "$tree" "$@"' in_tree "$tree" "$top" /usr/bin/env -i HOME=/root TERM=dumb LANG=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin ${http_proxy:+http_proxy="$http_proxy"} "$@"
}
