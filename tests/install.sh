#!/bin/sh
# Make sure that a tool or library is there: install Debian packages where the check fails and installing is allowed.
# usage: install.sh 'CHECK COMMAND' PACKAGE...      exit status 0 when the check passes in the end
check=$1
shift
sh -c "$check" >/dev/null 2>&1 && exit 0
as_root=
[ "$(id -u)" = 0 ] || as_root="sudo -n"
if command -v apt-get >/dev/null && $as_root true 2>/dev/null; then
    echo "installing $*"
    install="$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o DPkg::Lock::Timeout=300"
    $install "$@" >/dev/null 2>&1 || { $as_root apt-get update -qq >/dev/null 2>&1; $install "$@" >/dev/null 2>&1; }
    sh -c "$check" >/dev/null 2>&1 && exit 0
fi
echo "not found and not installable from here: $*" >&2
exit 1
