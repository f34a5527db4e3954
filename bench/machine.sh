#!/bin/sh
# What the times were taken on and with.
# usage: machine.sh COMPILER FLAGS
cc=$1 flags=$2
of_header() { printf '#include <%s>\n%s\n' "$1" "$2" | $cc -E - 2>/dev/null | tail -n 1 | tr -d '" '; }
echo "processor  $(awk -F': ' '/model name/ {print $2; exit}' /proc/cpuinfo 2>/dev/null), $(getconf _NPROCESSORS_ONLN) cores"
echo "compiler   $($cc --version | head -n 1), $flags -std=c99; _wide: -O3 -march=native -fno-math-errno"
echo "libraries  $(getconf GNU_LIBC_VERSION 2>/dev/null || uname -s), GSL $(of_header gsl/gsl_version.h GSL_VERSION)"
echo "load       $(uptime | sed 's/.*load average: //') at the start"
