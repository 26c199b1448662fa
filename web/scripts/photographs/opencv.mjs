/**
 * Installs Python with OpenCV, in its own virtual environment below `target`. It is installed once and never part of a
 * build.
 */
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { printed, ROOT, step } from '../steps.mjs';

const FOLDER = join(ROOT, 'target/opencv');
const PYTHON = join(FOLDER, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python');
const PACKAGE = 'opencv-python-headless';

/** @returns {Promise<string>} The path of the Python. */
export async function opencvPython() {
  if (existsSync(PYTHON) && printed(PYTHON, ['-c', 'import cv2']) !== undefined) return PYTHON;
  const missing = 'OpenCV could not be installed: Python 3 with venv and pip is needed. The reason is above.';
  await step('Python environment', 'python3', ['-m', 'venv', FOLDER], missing);
  await step('OpenCV', PYTHON, ['-m', 'pip', 'install', '--quiet', PACKAGE], missing);
  return PYTHON;
}
