#!/bin/sh
# Make sure that a tool or library is there. Where the check fails, Debian packages are installed, but only as root or
# where INSTALL=1 is set (make test INSTALL=1), which then calls sudo. Otherwise the command that would install them is
# printed, and the caller goes on without. Either way one line says what is missing and why it is wanted.
# usage: install.sh [-w 'REASON'] 'CHECK COMMAND' PACKAGE...      exit status 0 when the check passes in the end
reason=
if [ "$1" = -w ]; then
    reason=$2
    shift 2
fi
check=$1
shift
[ -n "$reason" ] || reason="since this finds nothing: $check"
is_there() { sh -c "$check" >/dev/null 2>&1; }
is_there && exit 0

as_root=
[ "$(id -u)" = 0 ] || as_root="sudo "
install="${as_root}apt-get install -y -qq --no-install-recommends"
if ! command -v apt-get >/dev/null; then
    echo "not here: $* (names of Debian packages), $reason" >&2
    exit 1
fi
if [ -n "$as_root" ] && [ "$INSTALL" != 1 ]; then
    echo "not here: $*, $reason; INSTALL=1 or this command installs it: $install $*" >&2
    exit 1
fi

# Several tests may want packages at the same time: one after the other.
if command -v flock >/dev/null; then
    exec 9>"${TMPDIR:-/tmp}/varmass-install-$(id -u).lock"
    flock 9
    is_there && exit 0
fi
echo "installing $*, $reason" >&2
install="${as_root}env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o DPkg::Lock::Timeout=300"
$install "$@" >/dev/null 2>&1 || { ${as_root}apt-get update -qq >/dev/null 2>&1; $install "$@" >/dev/null 2>&1; }
is_there && exit 0
echo "not here: $*, $reason; installing it failed: $install $*" >&2
exit 1
