# Read by ./lab: finds and installs what the machine lacks.

# Prints one word for each missing tool or library. Looks for the file itself, not for a package: a
# library installed by hand is fine.
missing_things() {
  compiler=${CXX:-c++}
  compiler=${compiler##*ccache }  # "ccache g++"
  command -v "$compiler" >/dev/null 2>&1 || { echo compiler; compiler=; }
  command -v cmake >/dev/null 2>&1 || echo cmake
  command -v ninja >/dev/null 2>&1 || command -v make >/dev/null 2>&1 || echo make
  command -v gnuplot >/dev/null 2>&1 || echo gnuplot
  if [ -z "$compiler" ]; then
    echo catch2 fmt json archive seccomp
    return
  fi
  {
    echo '#if !__has_include(<catch2/catch_test_macros.hpp>) && !__has_include(<catch2/catch.hpp>)'
    printf 'missing catch2\n#endif\n'
    for pair in fmt:fmt/format.h json:nlohmann/json.hpp archive:archive.h seccomp:seccomp.h; do
      printf '#if !__has_include(<%s>)\nmissing %s\n#endif\n' "${pair#*:}" "${pair%%:*}"
    done
  } | "$compiler" -E -P -x c++ - 2>/dev/null | sed -n 's/^missing //p'
}

package_of() {  # thing manager
  case $1:$2 in
    compiler:apt) echo g++ ;;
    compiler:dnf) echo gcc-c++ glibc-static libstdc++-static ;;
    catch2:dnf) echo catch-devel ;;
    fmt:apt) echo libfmt-dev ;;
    fmt:dnf) echo fmt-devel ;;
    json:apt) echo nlohmann-json3-dev ;;
    json:dnf) echo json-devel ;;
    archive:apt) echo libarchive-dev ;;
    archive:dnf) echo libarchive-devel ;;
    seccomp:apt) echo libseccomp-dev ;;
    seccomp:dnf) echo libseccomp-devel libseccomp-static ;;
    gnuplot:apt) echo gnuplot-nox ;;
    *) echo "$1" ;;
  esac
}

# Installs them. Prints what it runs; asks first at a terminal. CMake handles what
# cannot be installed: it fetches sources if there is a network, and otherwise reports what is missing.
install_what_is_missing() {
  set -- $(missing_things)
  [ $# = 0 ] && return
  manager=
  for candidate in apt-get:apt dnf:dnf; do
    command -v "${candidate%%:*}" >/dev/null 2>&1 && { manager=${candidate#*:}; break; }
  done
  packages=
  for thing in "$@"; do packages="$packages $(package_of "$thing" "$manager")"; done
  as_root=
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null 2>&1 && as_root="sudo "
  fi
  case $manager in
    apt) install="${as_root}apt-get install -y --no-install-recommends$packages" ;;
    dnf) install="${as_root}dnf install -y$packages" ;;
    *)
      echo "lab: missing: $*. There is no apt or dnf here: install them by hand." >&2
      only_gnuplot "$@" || exit 3
      return 0
      ;;
  esac
  echo "Missing: $*" >&2
  echo "  $install" >&2
  if [ -t 0 ] && [ -t 2 ] && [ "${CI:-}" != true ]; then
    printf 'Run this? [Y/n] ' >&2
    read -r answer
    case $answer in [nN]*)
      only_gnuplot "$@" && return 0
      echo "lab: run it yourself, or install$packages in another way, then try again" >&2
      exit 3
      ;;
    esac
  fi
  log=$build/setup.log
  export DEBIAN_FRONTEND=noninteractive
  if [ "$manager" = apt ]; then ${as_root}apt-get update >"$log" 2>&1 || true; fi
  if ! $install >>"$log" 2>&1 </dev/null; then
    tail -n 5 "$log" >&2
    echo "lab: that failed (all output: $log)" >&2
    only_gnuplot "$@" || case " $* " in *" compiler "* | *" cmake "* | *" make "*) exit 3 ;; esac
  fi
  rm -f "$build/CMakeCache.txt"  # look for them again
}

# gnuplot is optional: without it there are grades, but no plots.
only_gnuplot() {
  [ "$*" = gnuplot ] && echo "lab: continuing without gnuplot: no plots" >&2
}
