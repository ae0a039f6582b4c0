#!/usr/bin/env bash
# GNU units 2.22, UDUNITS 2.2.28 and pint 0.19.2 turn 60 rpm into 6.28 Hz.
# Guess: 60 turns a minute are 1 Hz, as on every instrument of a rotor test.
# Seen: a turn is 2 pi radian, a radian is 1, and Hz is 1/s. So all three say
# 6.283185 Hz, without a warning, and "1 Hz" is also 1 rad/s to them.
# Why it matters: the blade passing frequency of a fan, or the time between two
# cuts of a bird, is off by a factor of 2 pi when rpm is turned into Hz this way.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(units=2.22-2 udunits-bin=2.2.28-5 python3-pint=0.19.2-1)
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

gnu=$(units -f "$tmp/unpacked/usr/share/units/definitions.units" -t -- '60 rpm' Hz 2>/dev/null)
export UDUNITS2_XML_PATH="$tmp/unpacked/usr/share/xml/udunits/udunits2.xml"
[ -e "$UDUNITS2_XML_PATH" ] || unset UDUNITS2_XML_PATH
ud=$(LC_ALL=C udunits2 -A -H '60 rpm' -W Hz | awk 'NR == 1 { print $4 }')
pint=$(/usr/bin/python3 -c '
import pint
print(round(pint.UnitRegistry()("60 rpm").to("Hz").magnitude, 6))')
echo "60 rpm in Hz: GNU units $gnu, UDUNITS $ud, pint $pint"
for value in "$gnu" "$ud" "$pint"; do
  awk -v v="$value" 'BEGIN { exit !(v > 6.2831 && v < 6.2832) }'
done
