"""Run by Slicer: ends with status 0 if the command-line module named by the argument is loaded."""
import sys
import traceback

import slicer

status = 1
try:
    name = sys.argv[-1]
    module = getattr(slicer.modules, name.lower())
    node = slicer.cli.createNode(module)
    groups = node.GetNumberOfParameterGroups()
    parameters = [node.GetParameterName(group, i)
                  for group in range(groups)
                  for i in range(node.GetNumberOfParametersInGroup(group))]
    if "threads" not in parameters:
        raise RuntimeError(f"{name} has the parameters {parameters}")
    print(f"loaded {name} with {len(parameters)} parameters", flush=True)
    status = 0
except Exception:
    traceback.print_exc()
slicer.util.exit(status)
