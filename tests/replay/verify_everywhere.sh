#!/bin/sh
# The determinism gate: every bundled recording, in every build given, at 1, 2 and 8 threads, scalar and vector, must
# verify with one and the same last line.
#   verify_everywhere.sh BINARY ...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
found=0
failed=0
passed=0
for recording in "$root"/assets/replays/*.rec; do
    [ -e "$recording" ] || continue
    found=$((found + 1))
    expected=""
    for binary in "$@"; do
        for isa in scalar avx2 avx512; do
            for threads in 1 2 8; do
                # Every thread count with the kernels most machines have; the others once.
                [ "$isa" != avx2 ] && [ "$threads" != 2 ] && continue
                status=0
                output=$("$binary" replay "$recording" --verify --threads "$threads" --isa "$isa" 2>&1) || status=$?
                case $output in *"this machine has no"*) continue ;; esac
                line=$(printf '%s\n' "$output" | tail -n 1)
                [ -n "$expected" ] || expected=$line
                if [ "$status" -eq 0 ] && [ "$line" = "$expected" ] && [ "${line#verified }" != "$line" ]; then
                    passed=$((passed + 1))
                else
                    failed=$((failed + 1))
                    printf '%s --threads %s --isa %s: %s: exit %s, "%s", expected "%s"\n' "$binary" "$threads" "$isa" \
                        "$(basename "$recording")" "$status" "$line" "$expected"
                fi
            done
        done
    done
    printf '%s: %s\n' "$(basename "$recording")" "$expected"
done
printf '%s passed, %s failed\n' "$passed" "$failed"
[ "$found" -ge 2 ] || { echo "there are $found recordings in assets/replays; two are to be there"; exit 1; }
[ "$failed" -eq 0 ]
