#!/bin/sh
# uml_build.sh FOLDER - builds FOLDER/linux, a user-mode Linux with the real gpio-sim, from Debian's own kernel source. About three
# minutes of processor time, 150 MB to download, no root needed. Nothing is done when it is there.
set -e
folder=$(realpath -m "$1")
[ -x "$folder/linux" ] && exit 0
mkdir -p "$folder/tools"
cd "$folder"
apt-get -o APT::Sandbox::User=root -qq download linux-source-6.1 flex bison libfl2 bc
for package in flex_*.deb bison_*.deb libfl2_*.deb bc_*.deb; do dpkg-deb -x "$package" tools; done
PATH=$folder/tools/usr/bin:$PATH BISON_PKGDATADIR=$folder/tools/usr/share/bison M4=$(command -v m4 || true)
export PATH BISON_PKGDATADIR M4
LD_LIBRARY_PATH=$(echo "$folder"/tools/usr/lib/*/)
export LD_LIBRARY_PATH
dpkg-deb --fsys-tarfile linux-source-6.1_*.deb | tar xOf - ./usr/src/linux-source-6.1.tar.xz | tar xJf - \
    --exclude='*/drivers/gpu/*.[ch]' --exclude='*/drivers/net/*.[ch]' --exclude='*/drivers/media/*.[ch]' \
    --exclude='*/drivers/staging/*.[ch]' --exclude='*/sound/*.[ch]' --exclude='*/Documentation/*.rst' --exclude='*.dts*'
cd linux-source-6.1
# All 64 interrupts of user-mode Linux are taken; gpio-sim needs some for edges.
sed -i 's/^#define NR_IRQS[ \t]*UM_LAST_SIGNAL_IRQ$/#define NR_IRQS (UM_LAST_SIGNAL_IRQ + 64)/' arch/um/include/asm/irq.h
for option in 64BIT EXPERT PRINTK BINFMT_ELF BINFMT_SCRIPT BLOCK HOSTFS PROC_FS SYSFS TMPFS SHMEM DEVTMPFS TTY STDERR_CONSOLE NULL_CHAN \
    CONFIGFS_FS GPIOLIB GPIO_CDEV GPIO_CDEV_V1 GPIO_SIM EPOLL FUTEX SIGNALFD TIMERFD EVENTFD POSIX_TIMERS HIGH_RES_TIMERS \
    MULTIUSER FILE_LOCKING ADVISE_SYSCALLS MEMBARRIER; do echo "CONFIG_$option=y"; done >wanted
make -s ARCH=um SUBARCH=x86_64 tinyconfig
./scripts/kconfig/merge_config.sh -m .config wanted >/dev/null
make -s ARCH=um SUBARCH=x86_64 olddefconfig
make -s ARCH=um SUBARCH=x86_64 -j"$(nproc)" linux
cp linux ..
cd .. && rm -rf linux-source-6.1 tools ./*.deb
