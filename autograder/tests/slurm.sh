#!/bin/sh
# ./lab grade --slurm against a real Slurm: controller, one node and munge of this test's own, below
# a directory that goes with it. One task is killed, one is requeued; --resume gathers the others
# and judges the one that is missing. Exit status 77 where Slurm is not installed or does not start.
#
# usage: slurm.sh BUILD
set -eu
build=$(CDPATH= cd -- "$1" && pwd -P)
root=$(sed -n 's/^ "root": "\(.*\)",/\1/p' "$build/layout.json")
for program in slurmctld slurmd sbatch squeue scancel scontrol munged; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null 2>&1 || { echo "no $program"; exit 77; }
done
PATH=$PATH:/usr/sbin
place=$(mktemp -d)
chmod 755 "$place"
started=
finish() {
  for pid in $started; do kill "$pid" 2>/dev/null || true; done
  for pid in $started; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$place"
}
trap finish EXIT
trap 'exit 1' INT TERM

fail() {
  echo "FAILED: $*" >&2
  tail -n 20 "$place"/*.log "$place"/grades-verdicts/*.log >&2 2>/dev/null || true
  exit 1
}

# Waits until a command succeeds: five minutes and more, only against hanging.
wait_until() {
  tries=0
  until "$@" >/dev/null 2>&1; do
    tries=$((tries + 1))
    [ $tries -lt 1500 ] || return 1
    sleep 0.2
  done
}

# Slurm -------------------------------------------------------------------------------------------

who=$(id -un)
host=$(hostname -s 2>/dev/null || hostname)
port=$((20000 + $$ % 20000))
dd if=/dev/urandom of="$place/munge.key" bs=1024 count=1 2>/dev/null
chmod 600 "$place/munge.key"
mkdir "$place/munge" "$place/state" "$place/spool"
munged --foreground --force --key-file="$place/munge.key" --socket="$place/munge/socket" \
  --pid-file="$place/munge/pid" --log-file="$place/munged.log" --seed-file="$place/munge/seed" \
  >"$place/munged.out.log" 2>&1 &
started=$!
wait_until test -S "$place/munge/socket" || { echo "munged does not start"; exit 77; }
cat >"$place/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$who
SlurmdUser=$who
AuthType=auth/munge
AuthInfo=socket=$place/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=4096 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
SLURM_CONF=$place/slurm.conf
export SLURM_CONF
slurmctld -D >"$place/ctld.out.log" 2>&1 &
started="$started $!"
slurmd -D -N "$host" >"$place/slurmd.out.log" 2>&1 &
started="$started $!"
is_idle() { sinfo --noheader --format=%t | grep -q idle; }
wait_until is_idle || { echo "Slurm does not start"; tail -n 5 "$place"/*.log; exit 77; }

# A class: two that are judged at once, two that run out of time in four tasks ---------------------

MC_NO_BUILD=1
export MC_NO_BUILD
lab() { "$build/bin/lab" "$@"; }
mkdir "$place/class"
for student in ada bob; do
  mkdir "$place/class/$student"
  { cat "$root/starter/variance.cpp"; echo "// $student"; } >"$place/class/$student/variance.cpp"
done
for student in eve "zoe's"; do
  mkdir "$place/class/$student"
  { sed 's/throw todo("1.[1-4]");/for (volatile int i = 0;; i = i + 1) {}/' \
    "$root/starter/variance.cpp"; echo "// $student"; } >"$place/class/$student/variance.cpp"
done
cd "$place"
grade() { lab grade --class class --lab variance --csv grades.csv "$@"; }

grade --slurm --seed 7 >submitted.log || fail "no job was submitted"
job=$(sed -n 's/^job \([0-9]*\): 4 tasks, seed 7.*/\1/p' submitted.log)
[ -n "$job" ] || fail "what is printed: $(cat submitted.log)"
task_in() { [ "$(squeue --noheader --jobs="${job}_$1" --format=%T)" = "$2" ]; }

wait_until task_in 3 RUNNING || fail "task 3 does not run"
scancel --signal=KILL --full "${job}_3"
wait_until task_in 4 RUNNING || fail "task 4 does not run"
scontrol requeue "${job}_4"
restarted() { scontrol show job "${job}_4" | grep -q 'Restarts=1'; }
wait_until restarted || fail "task 4 is not requeued"
grade --resume >early.log 2>&1 && fail "it gathers while the job runs"
grep -q "job $job is still running" early.log || fail "it does not say that the job runs"
is_over() { [ -z "$(squeue --noheader --jobs="$job" 2>/dev/null)" ]; }
wait_until is_over || fail "the job does not end"
[ ! -e grades-verdicts/eve.json ] || fail "the killed task has a verdict"
[ -e "grades-verdicts/zoe's.json" ] || fail "the requeued task has no verdict"

# Gathered -----------------------------------------------------------------------------------------

grade --resume >gathered.log 2>&1 || fail "it does not gather: $(cat gathered.log)"
grep -q '4 submissions: 1 judged, 3 already judged; seed 7' gathered.log || fail "$(cat gathered.log)"
[ "$(wc -l <grades.csv)" = 5 ] || fail "not one row for each: $(cat grades.csv)"
[ "$(grep -c ',judged,0,' grades.csv)" = 4 ] || fail "all have 0 points: $(cat grades.csv)"
grade --resume >again.log 2>&1
grep -q '4 submissions: 0 judged, 4 already judged; seed 7' again.log || fail "$(cat again.log)"
echo "submitted, killed, requeued, gathered"
