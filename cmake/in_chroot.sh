#!/bin/sh
# in_chroot.sh TOOL ARGUMENT...: runs TOOL of the chroot that this script lies in, as root, in the
# caller's working directory. The host's files are under /host there, for as long as the tool runs;
# so is the folder for temporary files.
root=$(dirname "$(readlink -f "$0")")
exec unshare --mount sh -c '
  root=$1 directory=$2
  shift 2
  mount --rbind / "$root/host" &&
    mount -t proc proc "$root/proc" &&
    TMPDIR=/host${TMPDIR:-/tmp} exec chroot "$root" \
      sh -c "cd \"/host\$0\" && exec \"\$@\"" "$directory" "$@"
' sh "$root" "$(pwd -P)" "$@"
