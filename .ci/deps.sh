#!/bin/sh
# deps.sh GROUP... - installs the Debian packages of the groups host, test, firmware, emu, check, uml and bench that are missing, and only those.
# Silent and without a network when nothing is missing.
packages() {
    case $1 in
    host) echo gcc libc6-dev pkg-config libcairo2-dev libedit-dev ;;
    test) echo libcmocka-dev libmpfr-dev libgmp-dev clang libclang-rt-dev gnuplot-nox gnuplot-doc libgpiod-dev gpiod ;;
    firmware) echo gcc-arm-none-eabi libnewlib-arm-none-eabi ;;
    emu)
        echo qemu-system-arm
        # The boards' simulators are 32-bit programs.
        case $(uname -m) in x86_64) echo gcc-multilib ;; esac
        # Whoever has another Node.js than Debian's keeps it.
        command -v node >/dev/null || echo nodejs
        command -v npm >/dev/null || echo npm
        ;;
    check) echo clang-format clang-tidy cppcheck valgrind gcc-arm-none-eabi libnewlib-arm-none-eabi ;;
    uml) echo libc6-dev make xz-utils linux-source flex bison bc gpiod procps ;;
    bench) echo gnuplot-nox plplot-driver-cairo libplplot-dev ;;
    *) echo "deps.sh: unknown group $1" >&2; exit 2 ;;
    esac
}

missing=
for group in "$@"; do
    for package in $(packages "$group"); do
        case " $missing " in *" $package "*) continue ;; esac
        case $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) in
        *"ok installed") ;;
        *) missing="$missing $package" ;;
        esac
    done
done
[ -z "$missing" ] && exit 0

if ! command -v apt-get >/dev/null; then
    echo "This is not a Debian system, so please install the equivalents of:$missing" >&2
    # Perhaps they are there under other names: let the build find out.
    command -v dpkg-query >/dev/null && exit 1
    exit 0
fi
sudo=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Please install as root:  apt-get install$missing" >&2
        exit 1
    fi
    sudo=sudo
fi
echo "Installing:$missing"
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
# shellcheck disable=SC2086 # the list is meant to be split
if ! { $sudo apt-get -q update && $sudo apt-get -q install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    echo "Installing failed; the packages wanted are:$missing" >&2
    exit 1
fi
rm -f "$log"
