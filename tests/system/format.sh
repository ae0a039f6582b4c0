#!/usr/bin/env bash
# Every source file as clang-format 14 would write it. Usage: format.sh TOP
cd "$1" || exit 1
find include source tests -name '*.h' -o -name '*.cc' | sort | xargs clang-format-14 --dry-run --Werror
