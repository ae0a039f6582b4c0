#!/usr/bin/env bash
# Installs what is missing, builds everything and passes the tests:
#   bash tests/run.sh [further arguments of ctest]
# Takes over what prm/run.sh has built. BIRDSTRIKE_WERROR=ON makes warnings errors, as continuous integration does.
# CTest's closing line comes last; the exit code is CTest's.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}

mapfile -t packages <"$top/.ci/packages"
mapfile -t test_packages <"$top/.ci/test-packages"
# The style is that of clang-format 14, which Debian 12 alone has; elsewhere it is not checked.
system=$(. /etc/os-release && echo "$ID-${VERSION_ID:-}")
[ ! -f "$top/.ci/test-packages-$system" ] || mapfile -t -O "${#test_packages[@]}" test_packages <"$top/.ci/test-packages-$system"
bash "$top/.ci/install" "${packages[@]}" "${test_packages[@]}"

bash "$top/.ci/build" "$build" all -- -DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=ON -DBIRDSTRIKE_BENCHMARKS=ON \
  "-DBIRDSTRIKE_WERROR=${BIRDSTRIKE_WERROR:-OFF}"

cd "$build"
exec ctest --output-on-failure --parallel "$(nproc)" "$@"
