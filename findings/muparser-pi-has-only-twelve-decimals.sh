#!/usr/bin/env bash
# muParser 2.3.3: the built-in constant _pi is cut off after 12 decimals.
# Guess: _pi is pi to the precision of a double, 3.141592653589793.
# Seen: it is 3.141592653589. sin(_pi) is 7.9e-13 and not 1.2e-16, and the
# constant is smaller than pi by 1800 times the rounding of a double.
# Why it matters: deal.II and other codes read loads as muParser formulas. A
# half sine pulse sin(_pi*t) does not end at zero, and a convergence study that
# uses _pi in its exact solution stalls at 1e-13 relative error.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(libmuparser-dev=2.3.3-0.1 libmuparser2v5=2.3.3-0.1)
apt-cache show "${packages[@]}" >/dev/null 2>&1 || apt-get -qq update
mkdir -p "$tmp/debs/partial" "$tmp/unpacked"
apt-get install -qq -y --no-install-recommends --reinstall --download-only \
  -o Debug::NoLocking=1 -o APT::Sandbox::User=root \
  -o Dir::Cache::archives="$tmp/debs" "${packages[@]}" >/dev/null 2>&1
for deb in "$tmp"/debs/*.deb; do dpkg-deb -x "$deb" "$tmp/unpacked"; done
lib=$(echo "$tmp"/unpacked/usr/lib/*-linux-gnu)
export LD_LIBRARY_PATH="$lib:$lib/blas:$lib/lapack:$tmp/unpacked/usr/lib"
export PATH="$tmp/unpacked/usr/bin:$PATH" OMP_NUM_THREADS=1
export PYTHONPATH="$tmp/unpacked/usr/lib/python3/dist-packages"
cd "$tmp"

cat > pi.cc <<'EOF'
#include <muParser.h>
#include <cstdio>
int main()
{
  mu::Parser p;
  p.SetExpr("_pi");
  const double pi = p.Eval();
  p.SetExpr("sin(_pi)");
  const double s = p.Eval();
  std::printf("_pi = %.17g, less than pi by %.3g, sin(_pi) = %.3g\n", pi, 3.14159265358979324 - pi, s);
  return !(pi == 3.141592653589 && s > 7.8e-13 && s < 8.0e-13);
}
EOF
g++ -I"$tmp/unpacked/usr/include" pi.cc -L"$lib" -lmuparser -o pi
./pi
