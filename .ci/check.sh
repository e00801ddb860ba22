#!/bin/sh
# check.sh - what a compiler or an analyser can say without running anything. Tools that are not installed are
# named and passed over; `make install-deps` brings them. BUILDDIR says where objects may go.
cd "$(dirname "$0")/.." || exit 1
build=${BUILDDIR:-build}/check
failed=0
core=$(ls src/*.c src/*/*.c src/*/*/*.c 2>/dev/null)
sources="$core $(ls sim/*.c host/*.c hal/linux/*.c 2>/dev/null | grep -v lines_v)"
flags="-std=c11 -Isrc -I. -D_DEFAULT_SOURCE $(pkg-config --cflags cairo libedit)"

have() {
    command -v "$1" >/dev/null && return 0
    echo "not checked: $1 is not installed"
    return 1
}
verdict() { # status, what
    if [ "$1" -eq 0 ]; then echo "ok      $2"; else echo "FAILED  $2"; failed=1; fi
}

# Warnings, by both compilers, of everything including the tests.
sh .ci/warnings.sh
verdict $? "warnings"

# Does src/ need anything a bare Cortex-M0 has not? Heap, stdio, and floating point would show as symbols.
if have arm-none-eabi-gcc; then
    mkdir -p "$build"
    status=0
    forbidden='__aeabi_[fd][a-z0-9]*|__aeabi_[a-z0-9]*2[fd]|malloc|calloc|realloc|free|[a-z]*printf|puts|putchar|abort|exit|memalign'
    for f in $core; do
        o=$build/$(echo "$f" | tr / _).o
        arm-none-eabi-gcc -std=c11 -Isrc -I. -Os -mcpu=cortex-m0 -mthumb -ffunction-sections -Wall -Wextra -c "$f" -o "$o" || status=1
        found=$(arm-none-eabi-nm -u "$o" | grep -owE "$forbidden" | sort -u | tr '\n' ' ')
        [ -n "$found" ] && { echo "$f needs $found"; status=1; }
    done
    verdict $status "cortex-m0: src/ needs no heap, stdio or floating point"
fi

# src/ relies on the arithmetic right shift of gcc and clang (a static assertion in src/num/num.c says so).
# cppcheck 2.10 cannot parse a compound literal inside ?: (internalAstError), and the others are loops whose bounds it
# does not follow.
if have cppcheck; then
    # shellcheck disable=SC2086
    cppcheck -q --std=c11 -Isrc -I. -UHELP_PACKED -UPACKED_PAIRS --error-exitcode=1 --inline-suppr --enable=warning,performance,portability \
        --suppress=missingIncludeSystem --suppress=internalAstError \
        --suppress=shiftTooManyBitsSigned --suppress=shiftNegativeLHS --suppress=zerodivcond --suppress=objectIndex \
        --suppress=arrayIndexThenCheck --suppress=arrayIndexOutOfBoundsCond:src/scene/decimal_scan.h \
        --suppress=uninitvar:src/hidden/surface/windows_close.c --suppress=uninitvar:src/hidden/surface/edges_windows.c \
        --suppress=uninitvar:src/hidden/area/area_wires.c --suppress=uninitvar:src/hidden/surface/shaded.c \
        --suppress=ctuuninitvar:src/hidden/area/area_place.c $sources
    verdict $? "cppcheck"
fi

# Left out: what contradicts the style of fixed-point code; the analyser's va_list check, which clang-tidy 14 gets wrong
# whenever it is given more than one file; and its guesses about values across loops and calls, which were looked at
# one by one and were all wrong (valgrind and the sanitizers see what really happens).
if have clang-tidy; then
    checks='-*,clang-analyzer-*,-clang-analyzer-security.insecureAPI.*,-clang-analyzer-valist.*,bugprone-*'
    for no in CallAndMessage UndefinedBinaryOperatorResult NullDereference NonNullParamChecker DivideZero; do
        checks=$checks,-clang-analyzer-core.$no
    done
    for no in easily-swappable-parameters reserved-identifier narrowing-conversions not-null-terminated-result \
        implicit-widening-of-multiplication-result branch-clone too-small-loop-variable; do
        checks=$checks,-bugprone-$no
    done
    # shellcheck disable=SC2086
    clang-tidy --quiet --warnings-as-errors='*' --checks="$checks" $sources -- $flags 2>/dev/null
    verdict $? "clang-tidy"
fi
exit $failed
