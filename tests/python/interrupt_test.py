"""Ctrl-C ends what takes long."""
import signal
import subprocess
import sys
import time

import pytest


# Short steps, so that it takes long enough.
@pytest.mark.parametrize("call", ['w.simulate("pile", [200.0], **long)', 'w.simulate_many(["pile"] * 4, [200.0], threads=2, **long)',
                                  'w.Simulation("pile", **long).advance_to(200.0)'])
def test_ctrl_c_ends_it(call):
    script = ("import wuerfel as w\nlong = dict(integrator='moreau', step=1e-4)\nprint('on', flush=True)\n"
              f"try:\n    {call}\nexcept KeyboardInterrupt:\n    print('stopped')\n")
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "on\n"
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        assert child.communicate(timeout=60)[0] == "stopped\n"
