#!/bin/sh
# The determinism gate: every bundled recording, in every build given, at 1, 2 and 8 threads, scalar and vector, must
# verify with one and the same last line. As many at a time as the machine has cores.
#   verify_everywhere.sh BINARY ...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
results=$(mktemp)
trap 'rm -f "$results"' EXIT

# Four words a run: recording, binary, threads, instruction set. Every thread count with the kernels most machines have;
# the others once.
runs() {
    for recording in "$root"/assets/replays/*.rec; do
        for binary in "$@"; do
            for threads in 1 2 8; do printf '%s\0' "$recording" "$binary" "$threads" avx2; done
            for isa in scalar avx512; do printf '%s\0' "$recording" "$binary" 2 "$isa"; done
        done
    done
}

# The run, its exit code, and the last line it said; a line of this length is written whole.
runs "$@" | xargs -0 -P "$(nproc)" -n 4 sh -c '
    status=0
    output=$("$1" replay "$0" --verify --threads "$2" --isa "$3" 2>&1) || status=$?
    case $output in *"this machine has no"*) exit 0 ;; esac
    printf "%s %s %s %s|%s|%s\n" "$(basename "$0")" "$1" "$2" "$3" "$status" "$(printf "%s\n" "$output" | tail -n 1)"
' >"$results"

# Those that fail, or say other than the first run of their recording that succeeded.
sort "$results" | awk -F'|' '
    { split($1, run, " "); name = run[1] }
    $2 == 0 && $3 ~ /^verified / && !(name in expected) { expected[name] = $3; print name ": " $3; ++recordings }
    $2 == 0 && $3 == expected[name] { ++passed; next }
    { ++failed; print $1 ": exit " $2 ", \"" $3 "\", expected \"" expected[name] "\"" }
    END {
        printf "%d passed, %d failed\n", passed, failed
        if (recordings < 2) print "two recordings at least are to be in assets/replays, and to verify"
        exit failed > 0 || recordings < 2
    }'
