#!/usr/bin/env bash
# The arrows between rooms, checked over #include lines; and that the tests mirror the rooms. Usage: architecture.sh TOP
set -u
cd "$1" || exit 1
fail=0

declare -A allowed=(
  [core]="core"
  [material]="core material"
  [blade]="core material blade"
  [bird]="core material bird"
  [contact]="core contact"
  [time_control]="core time_control"
  [io]="core material blade bird contact time_control io"
  [simulation]="core material blade bird contact time_control io simulation"
)

for room in "${!allowed[@]}"; do
  while IFS=: read -r file line; do
    target=$(sed -E 's|.*birdstrike/([a-z_]+)/.*|\1|' <<<"$line")
    case " ${allowed[$room]} " in
      *" $target "*) ;;
      *) echo "$file includes the room '$target'; '$room' may include: ${allowed[$room]}"; fail=1 ;;
    esac
  done < <(grep -rHoE '#include <birdstrike/[a-z_]+/' "include/birdstrike/$room" "source/$room" | sed -E 's/$/x/')
done

# core and contact never speak of the parts; material never of meshes or particles (as identifiers, not in prose).
if grep -rnE '#include <deal.II/(grid|dofs|fe)/' include/birdstrike/{core,contact,bird,material,time_control} source/{core,contact,bird,material,time_control}; then
  echo "finite elements outside the blade"; fail=1
fi

# The mirror: every tested room is a room, every room with sources has tests.
for room in tests/unit/*/; do
  [ -d "source/$(basename "$room")" ] || { echo "$room mirrors no room"; fail=1; }
done
for room in source/*/; do
  ls "tests/unit/$(basename "$room")"/*_test.cc >/dev/null 2>&1 || { echo "no unit test mirrors $room"; fail=1; }
done

# Exactly the agreed top level.
odd=$(git ls-tree --name-only HEAD 2>/dev/null | grep -vxE 'CMakeLists\.txt|source|include|tests|prm|meshes|README\.md|LICENSE|CHANGELOG\.md|CMakePresets\.json|\..*')
[ -z "$odd" ] || { echo "top level holds more than it should: $odd"; fail=1; }

[ $fail -eq 0 ] && echo "architecture: all arrows allowed"
exit $fail
