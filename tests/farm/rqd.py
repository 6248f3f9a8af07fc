"""Runs a job of OpenCue by its real RQD: the part of Cuebot that reads the specification, replaces
the words of chunks and waits for layers is played here.

    python rqd.py JOB.xml FOLDER        with the PyPI packages opencue-rqd and opencue_proto

Prints a line for each task, and ends with 1 where one has failed."""

import concurrent.futures
import getpass
import os
import subprocess
import sys
import threading
import uuid
import xml.etree.ElementTree as xml

import grpc
from opencue_proto import report_pb2, report_pb2_grpc, rqd_pb2, rqd_pb2_grpc

RQD, CUEBOT = 18444, 18443
CONFIG = f"""[Override]
OVERRIDE_CUEBOT=127.0.0.1
CUEBOT_GRPC_PORT={CUEBOT}
RQD_GRPC_PORT={RQD}
RQD_BECOME_JOB_USER=False
OVERRIDE_NIMBY=False
OVERRIDE_IS_DESKTOP=False
OVERRIDE_CORES=2
OVERRIDE_HOSTNAME=127.0.0.1
OVERRIDE_MEMORY=4000000
"""


class Cuebot(report_pb2_grpc.RqdReportInterfaceServicer):
    def __init__(self):
        self.is_up, self.done, self.codes = threading.Event(), threading.Condition(), {}

    def ReportRqdStartup(self, request, context):
        self.is_up.set()
        return report_pb2.RqdReportRqdStartupResponse()

    def ReportStatus(self, request, context):
        return report_pb2.RqdReportStatusResponse()

    def ReportRunningFrameCompletion(self, request, context):
        report = request.frame_complete_report
        with self.done:
            self.codes[report.frame.frame_id] = report.exit_status
            self.done.notify_all()
        return report_pb2.RqdReportRunningFrameCompletionResponse()


def tasks(layer):
    """Commands of a layer's chunks, as Cuebot makes them of a range of single steps."""
    first, last = [int(n) for n in (layer.findtext("range").split("-") * 2)[:2]]
    chunk = int(layer.findtext("chunk"))
    for at in range(first, last + 1, chunk):
        end = min(at + chunk - 1, last)
        spec = f"{at}-{end}" if end > at else f"{at}"
        yield at, layer.findtext("cmd").replace("#FRAMESPEC#", spec)


def main(job_file, folder):
    job = xml.parse(job_file).getroot().find("job")
    config = os.path.join(folder, "rqd.conf")
    with open(config, "w", encoding="utf-8") as file:
        file.write(CONFIG)
    cuebot = Cuebot()
    server = grpc.server(concurrent.futures.ThreadPoolExecutor(4))
    report_pb2_grpc.add_RqdReportInterfaceServicer_to_server(cuebot, server)
    server.add_insecure_port(f"127.0.0.1:{CUEBOT}")
    server.start()
    with open(os.path.join(folder, "rqd.log"), "w", encoding="utf-8") as log:
        rqd = subprocess.Popen([sys.executable, "-m", "rqd", "-c", config], stdout=log, stderr=log)
    try:
        assert cuebot.is_up.wait(60), "RQD has not said that it is up"
        stub = rqd_pb2_grpc.RqdInterfaceStub(grpc.insecure_channel(f"127.0.0.1:{RQD}"))
        for layer in job.iter("layer"):
            for at, command in tasks(layer):
                frame = str(uuid.uuid4())
                name = f"{at:04}-{layer.get('name')}"
                run = rqd_pb2.RunFrame(
                    resource_id=frame, job_id="1", job_name=job.get("name"), frame_id=frame,
                    frame_name=name, layer_id=layer.get("name"), command=command,
                    user_name=getpass.getuser(), uid=os.getuid() or 1000, gid=os.getgid() or 1000,
                    log_dir=folder,
                    show="testing", shot="shot", num_cores=100)
                stub.LaunchFrame(rqd_pb2.RqdStaticLaunchFrameRequest(run_frame=run), timeout=30)
                with cuebot.done:
                    assert cuebot.done.wait_for(lambda: frame in cuebot.codes, 120), name
                print(name, "exit", cuebot.codes[frame], flush=True)
        return 1 if any(cuebot.codes.values()) else 0
    finally:
        rqd.terminate()
        rqd.wait(20)
        server.stop(None)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
