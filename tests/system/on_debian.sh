#!/usr/bin/env bash
# Both commands of the README on a fresh Debian, in a folder of its own (root; outside continuous integration, for release notes):
#   bash tests/system/on_debian.sh 12|13 [FOLDER, /var/tmp/birdstrike-debian-12 or -13] [first|both]
# Makes the system by debootstrap from the mirror of this machine's apt, copies the committed tree, runs the commands in it and
# prints times and CTest's closing lines. A folder that is there is used again with its packages; the tree is copied anew.
set -euo pipefail

release=${1:?"usage: on_debian.sh 12|13 [FOLDER] [first|both]"}
declare -A names=([12]=bookworm [13]=trixie)
name=${names[$release]:?"Debian 12 or 13"}
folder=$(realpath -m "${2:-/var/tmp/birdstrike-debian-$release}")
which=${3:-both}
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ "$(id -u)" -eq 0 ] || { echo "debootstrap needs root." >&2; exit 2; }
bash "$top/.ci/install" debootstrap

# Debian's archive, not that of security updates.
mirror=${MIRROR:-$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | grep -v security | head -n 1)}
if [ ! -e "$folder/etc/debian_version" ]; then
  debootstrap --variant=minbase "$name" "$folder" "$mirror" >"$folder.log" 2>&1 || { tail -n 20 "$folder.log" >&2; exit 1; }
fi
leave() { for part in dev/shm dev sys proc; do ! mountpoint -q "$folder/$part" || umount "$folder/$part"; done; }
trap leave EXIT
leave
mount -t proc proc "$folder/proc"
mount -t sysfs sysfs "$folder/sys"
mount --bind /dev "$folder/dev"
mount -t tmpfs tmpfs "$folder/dev/shm"
cp /etc/resolv.conf "$folder/etc/resolv.conf"

rm -rf "$folder/root/birdstrike"
mkdir -p "$folder/root/birdstrike"
git -C "$top" archive HEAD | tar -x -C "$folder/root/birdstrike"

run() # COMMAND: with the time that it took
{
  local begin=$SECONDS code=0
  chroot "$folder" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    bash -c "cd /root/birdstrike && $1" || code=$?
  echo "Debian $release: '$1' ended with exit code $code after $((SECONDS - begin)) s"
  return "$code"
}
run "bash prm/run.sh prm/frontal.prm"
[ "$which" = first ] || run "bash tests/run.sh" 2>&1 | tail -n 40
