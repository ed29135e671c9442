# Sourced by tools/play and tools/test: go to the project's root, install what is missing, name the shared steps.
# Nothing is fetched but Debian packages, and only those of tools/packages.txt that are not there yet.
set -eu
OLDPWD_OF_CALLER=$PWD
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$root"

say() { printf '%s\n' "$*" >&2; }

# install_missing build test ...: packages marked with any of these words.
install_missing() {
    if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
        say "This is not a Debian system: the packages of tools/packages.txt are taken to be there already."
        return 0
    fi
    missing=""
    for package in $(awk -v words="$*" 'BEGIN { n = split(words, w, " "); for (i = 1; i <= n; ++i) want[w[i]] = 1 }
                                        /^[^#]/ && ($2 in want) { print $1 }' tools/packages.txt); do
        status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
        case $status in *"ok installed") ;; *) missing="$missing $package" ;; esac
    done
    [ -z "$missing" ] && return 0
    say "Installing Debian packages:$missing"
    sudo=""
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null 2>&1; then
            say "They need root: run 'apt-get install$missing' as root, then this command again."
            exit 2
        fi
        say "(sudo is needed for that)"
        sudo=sudo
    fi
    # shellcheck disable=SC2086
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq update >&2 || say "apt-get update failed; going on with the lists that are there."
    # shellcheck disable=SC2086
    if ! $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing >&2; then
        say "apt-get could not install:$missing"
        exit 2
    fi
}

# build PRESET [TARGET ...]
# From scratch, sources are compiled together (tools/cmake/project_options.cmake), which takes half the time. A build tree that
# somebody works in stays as it is (-DGLASSHOUSE_UNITY=OFF parts them again): together, one changed source has fifteen others
# compiled again.
build() {
    preset=$1
    shift
    # A build tree that was copied or moved here with the checkout names another folder: begin it anew.
    cache="build/$preset/CMakeCache.txt"
    if [ -f "$cache" ] && ! grep -qF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then rm -rf "build/$preset"; fi
    together=""
    [ -d "build/$preset" ] || together=-DGLASSHOUSE_UNITY=ON
    # shellcheck disable=SC2086
    cmake --preset "$preset" $together >"build-$preset.log" 2>&1 || { cat "build-$preset.log" >&2; rm -f "build-$preset.log"; say "Configuring '$preset' failed."; exit 1; }
    rm -f "build-$preset.log"
    if [ $# -gt 0 ]; then cmake --build --preset "$preset" --target "$@"; else cmake --build --preset "$preset"; fi
}
