# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Shared by scripts/run and scripts/test (source it): installs what is missing, configures, builds. All of it speaks on stderr,
# and only when there is something to do.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }

# require_packages PURPOSE…: the packages of packages*.txt with these purposes are installed, or the script ends with status 2.
require_packages() {
  local wanted missing=() package as_root=()
  wanted=$(awk -v purposes=" $* " '!/^#/ && NF == 2 && index(purposes, " " $2 " ") { print $1 }' "$root"/scripts/packages*.txt)
  if ! command -v dpkg-query >/dev/null; then
    for package in g++ cmake ninja; do
      command -v "$package" >/dev/null && continue
      say "This is not a Debian system and '$package' is missing. scripts/packages.txt names what is needed."
      exit 2
    done
    return 0
  fi
  local installed
  # A package that is not known at all makes dpkg-query fail, and the others are listed nevertheless.
  # shellcheck disable=SC2086
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' || true)
  for package in $wanted; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null || { [ ! -t 0 ] && ! sudo -n true 2>/dev/null; }; then
      say "These packages are missing, and installing them needs root. Ask for:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      exit 2
    fi
    as_root=(sudo)
  fi
  say "Installing: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300)
  if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >/dev/null 2>&1; then
    "${apt[@]}" update >&2
    if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >&2; then
      say "These packages could not be installed: ${missing[*]}"
      exit 2
    fi
  fi
}

# How many compilers at once: one a core, as long as each has 1.5 GB. TWOSCALE_JOBS overrides.
job_count() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)
  [ "${memory:-1}" -ge 1 ] || memory=1
  echo "${TWOSCALE_JOBS:-$((cores < memory ? cores : memory))}"
}

# build PRESET [TARGET…]: build/PRESET is up to date. One build of a preset at a time.
build() {
  local preset=$1
  shift
  local directory=$root/build/$preset log
  mkdir -p "$directory"
  exec 9>"$directory/.lock"
  flock 9
  if [ ! -f "$directory/build.ninja" ] || [ "$root/CMakePresets.json" -nt "$directory/build.ninja" ]; then
    log=$directory/configure.log
    if ! (cd "$root" && cmake --preset "$preset") </dev/null >"$log" 2>&1; then
      cat "$log" >&2
      say "Configuring failed."
      exit 1
    fi
  fi
  # Ninja's lines are passed on, without those that say that nothing is to be done.
  if ! ninja -C "$directory" -j "$(job_count)" "$@" </dev/null 9>&- 2>&1 |
    awk '/^ninja: (no work to do|Entering directory)/ || /Re-checking globbed directories/ { next } { print; fflush() }' >&2; then
    say "The build failed."
    exit 1
  fi
  exec 9>&-
}
