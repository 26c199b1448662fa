/** Questions of the editor as events of the element. */
import { deepCopy } from '../document/project';
import type { PageQuestion } from '../editor/page_question';
import type { NamedFile } from '../editor/picture';
import type { Emit } from './events';

/** Asks the page. Returns whether the action may continue. */
export function ask(question: PageQuestion, emit: Emit): boolean {
  switch (question.type) {
    case 'beforeopen': {
      const { files, address } = question;
      return emit('beforeopen', { files: files.map(asFile), address });
    }
    case 'beforesave': {
      const { name, project, picture } = question;
      return emit('beforesave', { name, project: deepCopy(project), picture: picture && asFile(picture) });
    }
    case 'beforeexport':
      return emit('beforeexport', { name: question.name, kind: question.kind });
    case 'beforeadd':
    case 'beforeremove':
      return emit(question.type, { handles: deepCopy(question.handles) });
  }
}

function asFile({ name, file }: NamedFile): File {
  if (file instanceof File) return file;
  return new File([file as Blob], name, { type: file.type });
}
