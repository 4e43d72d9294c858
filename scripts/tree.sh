# shellcheck shell=bash disable=SC2154 # top is lib.sh's
# What scripts/package-test and scripts/armhf share: a Debian 12 of their own in a folder, so that this machine
# stays as it is. Source it after scripts/lib.sh. Needs root (chroot, mount).

# tree_make TREE: a bare Debian 12 in the folder TREE, unless there is one: a copy of the folder BARE where the
# environment names one (debootstrap's result), else debootstrap's. Mounts /dev, /proc and /sys there until the script
# ends; the source tree stands, read-only, at /src.
tree_make() {
    tree=$1
    [ "$(id -u)" = 0 ] || fail "cannot make a Debian tree: chroot and mount need root"
    trap tree_leave EXIT
    if [ ! -e "$tree/etc/debian_version" ]; then
        mkdir -p "$tree"
        if [ -n "${BARE:-}" ]; then
            step copy "copy $BARE to $tree" cp -a "$BARE/." "$tree/"
        else
            command -v debootstrap >/dev/null || fail "cannot make a Debian tree: no debootstrap; apt-get install debootstrap"
            step debootstrap "make a bare Debian 12 in $tree" debootstrap --variant=minbase bookworm "$tree"
        fi
    fi
    cp -L /etc/resolv.conf "$tree/etc/resolv.conf"
    cp /etc/apt/apt.conf.d/*prox* "$tree/etc/apt/apt.conf.d/" 2>/dev/null || true
    # Nothing that is installed starts in here.
    printf '#!/bin/sh\nexit 101\n' >"$tree/usr/sbin/policy-rc.d"
    chmod +x "$tree/usr/sbin/policy-rc.d"
    mkdir -p "$tree/src"
    mount --rbind /dev "$tree/dev" && mount --make-rslave "$tree/dev" && mount -t proc proc "$tree/proc" &&
        mount --bind "$top" "$tree/src" && mount -o remount,bind,ro "$tree/src" ||
        fail "cannot mount in $tree"
    mount -t sysfs sysfs "$tree/sys" 2>/dev/null || true # where this is a container, sysfs may be refused
}

# tree_leave: unmounts; removes the tree where tree_is_scratch says so.
tree_leave() {
    local place
    for place in src sys proc dev; do
        ! mountpoint -q "$tree/$place" || umount -l "$tree/$place"
    done
    [ -z "${tree_is_scratch:-}" ] || rm -rf --one-file-system "$tree"
}

# in_tree COMMAND...: as root in the tree, with nothing of this machine's environment but its proxy.
in_tree() {
    chroot "$tree" /usr/bin/env -i HOME=/root TERM=dumb LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        PATH=/usr/sbin:/usr/bin:/sbin:/bin ${http_proxy:+http_proxy="$http_proxy"} "$@"
}
