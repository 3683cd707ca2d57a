# SPDX-License-Identifier: BSD-3-Clause
# What ./demo and ./test share, to be sourced: Debian packages that are missing, configuring, building.

# Compiler and build tools, then the libraries, then what the tools call at run time.
packages="g++ cmake ninja-build pkg-config
  libginac-dev libeigen3-dev libfmt-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libsundials-dev libsuitesparse-dev
  libbenchmark-dev libgtest-dev libgmock-dev
  gnuplot-nox"

# What some tests are skipped without.
more_packages="clang python3-dev python3-numpy pybind11-dev dpkg-dev file
  texlive-latex-base texlive-latex-recommended texlive-pictures
  gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib
  libsimbody-dev libbullet-dev valgrind"

missing_packages() {
  for package in $packages; do
    status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) || status=
    [ "$status" = "install ok installed" ] || printf '%s ' "$package"
  done
}

# Installs what is missing, through sudo when not root; where that cannot be, names the packages and stops. On other
# systems names them and goes on.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian system: these packages, or what they are called here, are needed:" >&2
    echo $packages >&2
    return 0
  fi
  missing=$(missing_packages)
  [ -z "$missing" ] && return 0
  as_root=
  if [ "$(id -u)" != 0 ]; then
    as_root=sudo
    if ! command -v sudo >/dev/null; then
      echo "Missing Debian packages, and neither root nor sudo to install them. Run as root:" >&2
      echo "  apt-get install --no-install-recommends $missing" >&2
      exit 1
    fi
  fi
  echo "Installing: $missing"
  if ! { $as_root apt-get -q update && $as_root env DEBIAN_FRONTEND=noninteractive \
         apt-get -qy install --no-install-recommends $missing; } >build-packages.log 2>&1; then
    tail -n 20 build-packages.log >&2
    echo "Could not install the packages. Run as root:" >&2
    echo "  apt-get install --no-install-recommends $missing" >&2
    exit 1
  fi
  rm -f build-packages.log
}

# build TARGET...: the release preset in build/; nothing is done twice.
build() {
  cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log >&2; exit 1; }
  rm -f build-configure.log
  cmake --build --preset release --target "$@"
}
