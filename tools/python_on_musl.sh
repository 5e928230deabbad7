#!/bin/sh
# Compile this Debian's CPython on musl's C library, in /opt/musl, because neither Debian nor PyPI has one: by zig of
# PyPI, which brings musl's headers and a C++ library, from Debian's sources. /opt/musl/cc and c++ are the compilers.
# The libraries that are linked into it are those that pip and tfloom need, besides libz.so.1, which wheels of PyPI expect.
set -eu
prefix=/opt/musl
sources=$prefix/src
mkdir -p "$sources"
python3 -m venv $prefix/zig
$prefix/zig/bin/pip install --quiet --disable-pip-version-check ziglang
zig=$($prefix/zig/bin/python -c 'import ziglang; print(ziglang.__path__[0])')/zig
for language in cc c++; do
    # CPython states the time at which it was compiled, which Debian's compilers allow, and zig reports as an error.
    printf '#!/bin/sh\nexec %s %s -target x86_64-linux-musl -dynamic -Wno-error=date-time "$@"\n' "$zig" $language > $prefix/$language
    chmod +x $prefix/$language
done
sed -n 's/^deb /deb-src /p' /etc/apt/sources.list > /etc/apt/sources.list.d/sources.list
apt-get update --quiet
cd "$sources"
for name in zlib bzip2 libffi openssl sqlite3 python3.13; do
    # The newest of which the mirror has the sources: of an update's, it may lack them.
    for version in $(apt-cache showsrc --only-source $name | sed -n 's/^Version: //p' | sort -rVu); do
        if apt-get source --quiet --download-only $name="$version"; then break; fi
    done
done
for file in *.orig.tar.*z; do tar -xf "$file"; done

# Without the sanitizer of undefined behaviour, which zig uses by itself.
export CC=$prefix/cc CXX=$prefix/c++ CFLAGS="-O2 -fPIC -fno-sanitize=undefined"
cd "$sources"/zlib*
./configure --static --prefix=$prefix
make -j2 install
$CC -shared -o $prefix/lib/libz.so.1 -Wl,-soname,libz.so.1 -Wl,--whole-archive $prefix/lib/libz.a
echo "/lib/x86_64-linux-musl:/usr/lib/x86_64-linux-musl:$prefix/lib" > /etc/ld-musl-x86_64.path
cd "$sources"/bzip2*
make CC=$CC CFLAGS="$CFLAGS" libbz2.a
cp libbz2.a $prefix/lib
cp bzlib.h $prefix/include
cd "$sources"/libffi*
autoreconf -fi
./configure --host=x86_64-linux-musl --disable-shared --disable-docs --prefix=$prefix
make -j2 install
cd "$sources"/sqlite3*
./configure --host=x86_64-linux-musl --disable-shared --disable-tcl --prefix=$prefix
make sqlite3.c
# shellcheck disable=SC2086
$CC $CFLAGS -c sqlite3.c -o sqlite3.o
ar rcs $prefix/lib/libsqlite3.a sqlite3.o
cp sqlite3.h $prefix/include
cp sqlite3.pc $prefix/lib/pkgconfig
cd "$sources"/openssl*
./Configure linux-x86_64 no-shared no-tests no-docs no-apps no-asm --prefix=$prefix --libdir=lib --openssldir=/etc/ssl
make -j2 build_libs
make install_dev
cd "$sources"/Python*
# configure recognizes musl by a macro that zig's headers don't define; the name is part of the names of extensions.
sed -i 's/^#  ifdef __DEFINED_va_list/#  if 1/' Misc/platform_triplet.c
PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig CFLAGS="-fno-sanitize=undefined -I$prefix/include" LDFLAGS=-L$prefix/lib \
    ./configure --build=x86_64-linux-musl --prefix=$prefix --with-openssl=$prefix --disable-test-modules
make -j2 all
make install
