#!/usr/bin/env bash
# A real Slurm of one node on the loopback interface, for tests: munge, slurmctld and slurmd as
# Debian's packages slurm-wlm and munge bring them, with all they write in one folder.
#   deploy/slurm/one-node.sh up FOLDER       starts it; FOLDER must be new or empty
#   deploy/slurm/one-node.sh down FOLDER     ends everything that `up` started, and its jobs
#   deploy/slurm/one-node.sh start|stop|kill controller|node FOLDER
#                                            one daemon: stop asks it to end, kill is SIGKILL
# Needs root. Clients then need SLURM_CONF=FOLDER/slurm.conf. Not for production: it runs as root
# and keeps no accounting; deploy/slurm/slurm.conf.example is for a site.
set -euo pipefail

fail() { echo "one-node.sh: $*" >&2; exit 1; }
usage() { sed -n '2,9s/^# \{0,1\}//p' "$0" >&2; exit 2; }

# A port of 127.0.0.1 that nothing listens on.
free_port() {
  local port
  for _ in {1..200}; do
    port=$((20000 + RANDOM % 20000))
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
  done
  fail "no free port found"
}

write_configuration() {
  local cpus
  cpus=$(nproc)
  cat >"$folder/slurm.conf" <<CONF
ClusterName=leda-test
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$folder/run/munge.sock
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$folder/log/jobcomp.txt
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0
ReturnToService=2
MaxArraySize=${LEDA_SLURM_MAX_ARRAY_SIZE:-10001}
MinJobAge=${LEDA_SLURM_MIN_JOB_AGE:-300}
KillWait=2
SlurmctldTimeout=30
SlurmdTimeout=30
MessageTimeout=5
SlurmdParameters=config_overrides
NodeName=localhost NodeAddr=127.0.0.1 CPUs=$cpus RealMemory=4000 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
}

pid_of() { cat "$folder/run/$1.pid" 2>/dev/null || true; }

is_up() {
  local pid
  pid=$(pid_of "$1")
  [[ -n $pid ]] && kill -0 "$pid" 2>/dev/null
}

# Waits until a condition holds: wait_for SECONDS COMMAND...
wait_for() {
  local until=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < until)) || return 1
    sleep 0.2
  done
}

is_gone() { ! is_up "$1"; }
# The controller knows a new node before it has heard of it: it must also answer.
node_is_ready() { [[ $(timeout 5 sinfo -h -o %T 2>/dev/null) =~ ^(idle|mixed|allocated)$ ]]; }
controller_answers() { timeout 5 scontrol ping >/dev/null 2>&1; }

start_munge() {
  mkdir -p "$folder/key"
  chmod 0700 "$folder/key"
  [[ -e $folder/key/munge.key ]] || (umask 077; head -c 1024 /dev/urandom >"$folder/key/munge.key")
  munged --key-file="$folder/key/munge.key" --socket="$folder/run/munge.sock" \
    --pid-file="$folder/run/munge.pid" --log-file="$folder/log/munge.log" \
    --seed-file="$folder/key/munge.seed"
}

daemon_start() {
  case $1 in
    controller) slurmctld -i && wait_for 20 controller_answers ;;
    node) slurmd -N localhost && wait_for 30 node_is_ready ;;
    *) usage ;;
  esac || fail "the $1 did not start: see $folder/log"
}

daemon_end() {  # SIGNAL controller|node
  local pid_file pid
  case $2 in controller) pid_file=slurmctld ;; node) pid_file=slurmd ;; *) usage ;; esac
  pid=$(pid_of "$pid_file")
  [[ -n $pid ]] || return 0
  kill "-$1" "$pid" 2>/dev/null || true
  wait_for 20 is_gone "$pid_file" || kill -KILL "$pid" 2>/dev/null || true
  rm -f "$folder/run/$pid_file.pid"
}

up() {
  ((EUID == 0)) || fail "must run as root"
  for program in munged slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || fail "$program is not installed (slurm-wlm, munge)"
  done
  [[ -z $(ls -A "$folder" 2>/dev/null) ]] || fail "$folder is not empty"
  mkdir -p "$folder"/{run,log,state,spool}
  chmod 0755 "$folder" "$folder/run"
  write_configuration
  trap 'down' ERR EXIT
  start_munge
  daemon_start controller
  daemon_start node
  trap - ERR EXIT
}

down() {
  trap - ERR EXIT
  if is_up slurmctld && is_up slurmd; then
    timeout 5 scancel --state=PENDING --user=root 2>/dev/null || true
    timeout 5 scancel --user=root 2>/dev/null || true
    wait_for 8 no_jobs || true
  fi
  daemon_end TERM node
  daemon_end TERM controller
  local pid
  pid=$(pid_of munge)
  [[ -z $pid ]] || kill "$pid" 2>/dev/null || true
}

no_jobs() { [[ -z $(timeout 5 squeue -h 2>/dev/null) ]]; }

(($# >= 2)) || usage
export PATH=$PATH:/usr/sbin:/sbin
what=$1
if [[ $what == up || $what == down ]]; then
  (($# == 2)) || usage
  folder=$2
else
  (($# == 3)) || usage
  folder=$3
fi
[[ $folder == /* ]] || folder=$PWD/$folder
export SLURM_CONF=$folder/slurm.conf
case $what in
  up) up ;;
  down) down ;;
  start) daemon_start "$2" ;;
  stop) daemon_end TERM "$2" ;;
  kill) daemon_end KILL "$2" ;;
  *) usage ;;
esac
