#!/bin/sh
# get_v2.sh FOLDER - unpacks libgpiod 2.x of the next Debian release beside the installed 1.6: library and headers, nothing
# installed. Writes FOLDER/env, which a build with it sources, and FOLDER/tool, which runs `tool gpioinfo ...` with that release's C
# library. Fails when the packages cannot be had.
set -e
folder=$(realpath -m "$1")
[ -e "$folder/env" ] && [ -e "$folder/tool" ] && exit 0
rm -rf "$folder"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/archives/partial"
cd "$folder"
: >apt/status
# The mirror that this machine uses anyway.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null | grep -v security | head -1)
[ -n "$mirror" ]
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror trixie main" >apt/sources.list
apt() {
    timeout 60 apt-get -qq -o Acquire::Retries=0 -o Acquire::http::Timeout=10 -o Dir::State::Lists="$folder/apt/lists" -o Dir::State::status="$folder/apt/status" \
        -o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::Cache="$folder/apt" \
        -o Dir::Cache::archives="$folder/apt/archives" -o Acquire::Languages=none -o APT::Sandbox::User=root "$@"
}
apt update
apt download libgpiod3 libgpiod-dev gpiod libc6 libedit2 libtinfo6 libbsd0 libmd0
for package in libgpiod*.deb; do dpkg-deb -x "$package" root; done
# The C library apart: the program is built with, and runs on, this machine's.
for package in *.deb; do dpkg-deb -x "$package" tools; done
rm -rf apt ./*.deb
arch=$(gcc -print-multiarch)
lib=$folder/root/usr/lib/$arch
cat >tool <<END
#!/bin/sh
program=\$1
shift
exec $(echo "$folder/tools/usr/lib/$arch"/ld-linux*.so.*) --library-path $folder/tools/usr/lib/$arch $folder/tools/usr/bin/\$program "\$@"
END
chmod +x tool
cat >env <<END
export GPIO_PKG_CONFIG='env PKG_CONFIG_SYSROOT_DIR=$folder/root PKG_CONFIG_LIBDIR=$lib/pkgconfig pkg-config' GPIO_LDFLAGS=-Wl,-rpath,$lib
END
