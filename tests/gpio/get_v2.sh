#!/bin/sh
# get_v2.sh FOLDER - unpacks libgpiod 2.x of the next Debian release beside the installed 1.6: library and headers, nothing
# installed. Writes FOLDER/env, which a build with it sources. Fails when the packages cannot be had.
set -e
folder=$(realpath -m "$1")
[ -e "$folder/env" ] && exit 0
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
apt download libgpiod3 libgpiod-dev
for package in *.deb; do dpkg-deb -x "$package" root; done
rm -rf apt ./*.deb
lib=$folder/root/usr/lib/$(gcc -print-multiarch)
cat >env <<END
export GPIO_PKG_CONFIG='env PKG_CONFIG_SYSROOT_DIR=$folder/root PKG_CONFIG_LIBDIR=$lib/pkgconfig pkg-config' GPIO_LDFLAGS=-Wl,-rpath,$lib
END
