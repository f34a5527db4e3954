#!/bin/sh
# tests/install.sh installs as root, or by sudo where INSTALL=1 is set, and otherwise says what would. The tools that it calls
# are those of this test: they write down that they were called and install nothing but a file, `there`.
# usage: test_install.sh BUILD_FOLDER, from the top of the project
build=$1/install
. tests/check.sh
case $build in /*) ;; *) build=$PWD/$build ;; esac
mkdir "$build/bin"
unset INSTALL

tool() { # tool NAME BODY
    printf '#!/bin/sh\n%s\n' "$2" >"$build/bin/$1"
    chmod +x "$build/bin/$1"
}
tool sudo 'echo "sudo $*" >>"$calls"; exec "$@"'
tool apt-get 'echo "apt-get $*" >>"$calls"; case "$*" in *\ useful) touch "$there" ;; esac'

# install UID COMMAND... : as the user of that number, where nothing is installed yet; output and exit status to `said`
install() {
    tool id "echo $1"
    shift
    rm -f "$build/there" "$build/calls"
    touch "$build/calls"
    PATH="$build/bin:$PATH" TMPDIR=$build calls=$build/calls there=$build/there "$@" >"$build/said" 2>&1
    echo "status $?" >>"$build/said"
}
script="sh tests/install.sh -w which_is_the_reason"
check_there="test -e $build/there"
says() { grep -q -e "$1" "$build/said" || { cat "$build/said"; false; }; }
called() { grep -q -e "$1" "$build/calls"; }
installs() { says '^status 0$' && says "^installing useful, which_is_the_reason" && test -e "$build/there"; }

install 0 $script "$check_there" useful
check "root: installs, and says what and why" installs
check "root: without sudo" fails called sudo
install 1000 $script "$check_there" useful
check "others: fails" says '^status 1$'
check "others: nothing is called" test ! -s "$build/calls"
check "others: the reason and the command" says 'which_is_the_reason.*sudo apt-get install .*useful'
install 1000 env INSTALL=1 $script "$check_there" useful
check "others, INSTALL=1: installs, and says what and why" installs
check "others, INSTALL=1: by sudo" called '^sudo .*apt-get install .* useful'
install 0 $script "$check_there" useless
check "a package that does not help: fails" says '^status 1$'
check "a package that does not help: says so" says 'installing it failed'
install 0 $script true useful
check "what is there already is not installed" test ! -s "$build/calls"
check_finish install
