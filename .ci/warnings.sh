#!/bin/sh
# warnings.sh [COMPILER...] - every C file, tests and benches included, through each compiler's front end (gcc and clang), JOBS at a time: no
# warning. Prints cmocka's lines, as it is a test of `make test`: what the build's own compiler lets pass, or the build
# does not build, breaks unseen otherwise. Versions that are not known to be quiet may warn of other things: those are shown and count as errors only.
cd "$(dirname "$0")/.." || exit 1
flags='-std=c11 -Isrc -I. -D_DEFAULT_SOURCE -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -O1 -fsyntax-only'
flags="$flags $(pkg-config --cflags cairo libedit)"
failed=0
[ $# -gt 0 ] || set -- gcc clang
for cc in "$@"; do
    command -v "$cc" >/dev/null || { echo "# skipped: $cc is not installed"; continue; }
    case "$cc $($cc -dumpversion)" in
    'gcc 12'* | 'clang 14'*) strict=-Werror ;;
    *) strict= ;;
    esac
    said=$(mktemp)
    files=$(ls src/*.c src/*/*.c src/*/*/*.c sim/*.c host/*.c hal/linux/*.c tests/*/*.c tests/*/tools/*.c 2>/dev/null |
        grep -v -e hal/linux/lines_v -e tests/unit/test_uart.c) # one for each libgpiod; one that reads a port
    # shellcheck disable=SC2086
    if echo "$files" | xargs -P "${JOBS:-$(nproc)}" -n 24 $cc $flags $strict >"$said" 2>&1 &&
        $cc $flags $strict -Itests/unit/fake_port tests/unit/test_uart.c >>"$said" 2>&1; then
        echo "[       OK ] $cc: no warning in $(($(echo "$files" | wc -l) + 1)) files"
        [ -s "$said" ] && sed 's/^/# /' "$said"
    else
        cat "$said"
        failed=$((failed + 1))
    fi
    rm -f "$said"
done
# Many a Linux board has 32 bits: where one can tell (.ci/deps.sh emu), that program has no warning, either.
if echo '#include <stdio.h>' | gcc -m32 -fsyntax-only -x c - 2>/dev/null; then
    # shellcheck disable=SC2086
    if ls src/*.c src/*/*.c src/*/*/*.c sim/*.c host/*.c |
        xargs -P "${JOBS:-$(nproc)}" -n 24 gcc -m32 $flags 2>&1 | grep -E 'warning|error' >"${said:=$(mktemp)}"; then
        cat "$said"
        failed=$((failed + 1))
    else
        echo "[       OK ] gcc -m32: no warning"
    fi
    rm -f "$said"
fi
[ $failed -eq 0 ] && exit 0
echo "[  FAILED  ] $failed test(s), listed above"
exit 1
