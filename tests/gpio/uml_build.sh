#!/bin/sh
# uml_build.sh FOLDER - builds FOLDER/linux, a user-mode Linux with the kernel's own gpio-sim, from Debian's kernel source
# (packages of .ci/deps.sh uml). Debian's ready user-mode-linux has no gpio. About three minutes of processor time and 1 GB while it
# builds; no root needed. Does nothing when it is there already.
set -e
mkdir -p "$1"
folder=$(realpath "$1")
[ -x "$folder/linux" ] && exit 0
# The newest, if there are several.
source=$(find /usr/src -maxdepth 1 -name 'linux-source-*.tar.xz' | sort -V | tail -1)
[ -n "$source" ] || { echo "uml_build.sh: no /usr/src/linux-source-*.tar.xz: install linux-source" >&2; exit 1; }
echo "building a user-mode Linux with gpio-sim from $source: some minutes, once"
rm -rf "$folder/source"
mkdir "$folder/source"
cd "$folder/source"
# What a user-mode kernel cannot have is most of the source.
tar -xJf "$source" --strip-components=1 --exclude='*/drivers/gpu/*.[ch]' --exclude='*/drivers/net/*.[ch]' \
    --exclude='*/drivers/media/*.[ch]' --exclude='*/drivers/staging/*.[ch]' --exclude='*/sound/*.[ch]' --exclude='*/Documentation/*.rst' \
    --exclude='*.dts*'
# All 64 interrupts of user-mode Linux are taken; gpio-sim needs some for edges.
sed -i 's/^#define NR_IRQS[ \t]*UM_LAST_SIGNAL_IRQ$/#define NR_IRQS (UM_LAST_SIGNAL_IRQ + 64)/' arch/um/include/asm/irq.h
for option in 64BIT EXPERT PRINTK BINFMT_ELF BINFMT_SCRIPT BLOCK HOSTFS PROC_FS SYSFS TMPFS SHMEM DEVTMPFS TTY STDERR_CONSOLE NULL_CHAN \
    CONFIGFS_FS GPIOLIB GPIO_CDEV GPIO_CDEV_V1 GPIO_SIM EPOLL FUTEX SIGNALFD TIMERFD EVENTFD POSIX_TIMERS HIGH_RES_TIMERS \
    MULTIUSER FILE_LOCKING ADVISE_SYSCALLS MEMBARRIER; do echo "CONFIG_$option=y"; done >wanted
# A make that runs this must not hand its variables to the kernel's.
unset MAKEFLAGS MFLAGS MAKELEVEL BUILDDIR V CC CFLAGS
kernel_make() { make -s ARCH=um SUBARCH=x86_64 "$@"; }
kernel_make tinyconfig
./scripts/kconfig/merge_config.sh -m .config wanted >/dev/null
kernel_make olddefconfig
kernel_make -j"${JOBS:-2}" linux 2>"$folder/warnings" || { cat "$folder/warnings"; exit 1; }
strip -o "$folder/linux.new" linux
cd "$folder"
rm -rf source
mv linux.new linux
