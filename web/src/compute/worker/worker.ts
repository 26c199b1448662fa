/** The solving worker: a {@link SolverService} that receives requests from the page and responds. */
import { SolverService } from '../solver_service';

declare const self: DedicatedWorkerGlobalScope;

const service = new SolverService((reply, transfer = []) => self.postMessage(reply, transfer), {
  warmUp: true,
});

self.onmessage = ({ data }) => service.push(data);
